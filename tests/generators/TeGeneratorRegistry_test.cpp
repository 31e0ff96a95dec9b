#include "generators/TeGeneratorRegistry.h"

#include "generators/TeSpecification.h"
#include "generators/base/TeRandom.h"
#include "generators/filters/TeBandFilter.h"
#include "generators/function/TeFunctionGenerator.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

const TeGeneratorRegistry& registry() { return TeGeneratorRegistry::instance(); }

template <class T> std::string errorOf(const TeResult<T>& result) {
  return result.ok() ? "" : result.error().message;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

} // namespace

TEST(TeGeneratorRegistry, SpecificationsSetParameters) {
  const auto generator = registry().generator("function:z=\"min(x, 3) + 1\"");
  ASSERT_TRUE(generator.ok()) << errorOf(generator);
  EXPECT_EQ(static_cast<TeFunctionGenerator&>(**generator).z, "min(x, 3) + 1");
  const auto filter = registry().filter("band:k=0.8,passes=2");
  ASSERT_TRUE(filter.ok());
  EXPECT_EQ(static_cast<TeBandFilter&>(**filter).k, 0.8);
  EXPECT_EQ(static_cast<TeBandFilter&>(**filter).passes, 2);
  EXPECT_TRUE(registry().source("faults:faults=80", {"band:k=0.9,passes=5", "matrix"}).ok());
}

TEST(TeGeneratorRegistry, EachMistakeIsOneLineThatHelps) {
  EXPECT_TRUE(contains(errorOf(registry().generator("fualts")),
                       "unknown generator \"fualts\"; did you mean faults? (known: "));
  EXPECT_TRUE(contains(errorOf(registry().filter("bnad")), "unknown filter \"bnad\"; did you mean band?"));
  EXPECT_TRUE(contains(errorOf(registry().generator("band")), "unknown generator \"band\""));
  EXPECT_TRUE(contains(errorOf(registry().filter("faults")), "unknown filter \"faults\""));
  EXPECT_TRUE(
      contains(errorOf(registry().filter("band:pases=3")), "did you mean passes? (known: k, passes)"));
  EXPECT_TRUE(
      contains(errorOf(registry().filter("band:k=nan")), "band: k is \"nan\", must be a number, 0 to 1"));
  EXPECT_TRUE(contains(errorOf(registry().filter("band:k=0.9;passes=3")), "band: k is"));
  EXPECT_TRUE(contains(errorOf(registry().filter("band:k=0.9,")), "column 12: expected parameter=value"));
  EXPECT_TRUE(contains(errorOf(registry().filter("band:")), "column 6: expected parameter=value"));
  EXPECT_TRUE(contains(errorOf(registry().filter("band:k")), "column 7: expected parameter=value"));
  EXPECT_TRUE(contains(errorOf(registry().filter("band:k=0.9 ")), "column 11: a value with a blank"));
  EXPECT_TRUE(contains(errorOf(registry().filter("band k=1")), "column 5: expected ':' or the end"));
  EXPECT_TRUE(contains(errorOf(registry().filter("band:k=1,k=1")), "parameter k is given twice"));
  EXPECT_TRUE(contains(errorOf(registry().filter("band:k=\"1\"x")), "column 11: expected ',' or the end"));
  EXPECT_TRUE(contains(errorOf(registry().filter("band:k=\"1")), "column 8: the quote is not closed"));
  EXPECT_TRUE(
      contains(errorOf(registry().filter("band:k=1\"")), "column 9: a value with a blank or a quote"));
  EXPECT_TRUE(contains(errorOf(registry().generator("")), "column 1: a name is missing"));
  EXPECT_TRUE(contains(errorOf(registry().generator(":k=1")), "column 1: a name is missing"));
  EXPECT_TRUE(contains(errorOf(registry().source("function:z=\"1+\"")), "function: z: expression"));
  EXPECT_TRUE(contains(errorOf(registry().source("function", {"matrix:size=4"})), "not an odd number"));
  EXPECT_TRUE(contains(errorOf(registry().generator(std::string(100000, 'a'))), "longer than 65536"));
}

TEST(TeGeneratorRegistry, AnyTextIsASpecificationOrOneLine) {
  TeRandom random(1, 1, {});
  const std::string alphabet = "band:k=0.9,passes=5\"\" \n\x01\xFF"
                               "function:z=sin(x)+*/^";
  for (int i = 0; i < 20000; ++i) {
    std::string text = random.below(2) ? "band:" : "function:z=";
    for (std::uint64_t length = random.below(20); length > 0; --length)
      text += alphabet[random.below(alphabet.size())];
    const std::string message =
        random.below(2) ? errorOf(registry().source(text)) : errorOf(registry().filter(text));
    ASSERT_EQ(message.find('\n'), std::string::npos);
    ASSERT_LT(message.size(), 500u);
  }
}

TEST(TeGeneratorRegistry, SpecificationsReadBack) {
  auto generator = registry().generator("function").value();
  auto& function = static_cast<TeFunctionGenerator&>(*generator);
  for (const char* z : {"x", "min(x, y)", "say \"x\"", "a,b", "", "\"", "\"\"\""}) {
    function.z = z;
    const std::string text = teSpecification("function", generator->parameters());
    const auto again = registry().generator(text);
    ASSERT_TRUE(again.ok()) << text << ": " << errorOf(again);
    EXPECT_EQ(static_cast<TeFunctionGenerator&>(**again).z, z) << text;
  }
  for (const std::string& name : registry().generatorNames()) {
    auto made = registry().generator(name).value();
    const std::string text = teSpecification(name, made->parameters());
    auto again = registry().generator(text);
    ASSERT_TRUE(again.ok()) << text << ": " << errorOf(again);
    EXPECT_EQ(teSpecification(name, (*again)->parameters()), text);
  }
}

TEST(TeGeneratorRegistry, ProgramsAddTheirOwn) {
  TeGeneratorRegistry own;
  const auto factory = [] { return std::make_unique<TeFunctionGenerator>(); };
  EXPECT_TRUE(own.addGenerator("my-hills", "hills of mine", factory).ok());
  EXPECT_TRUE(own.addFilter("band2", "another", [] { return std::make_unique<TeBandFilter>(); }).ok());
  EXPECT_EQ(own.generatorNames(), std::vector<std::string>{"my-hills"});
  EXPECT_EQ(own.filterNames(), std::vector<std::string>{"band2"});
  EXPECT_EQ(own.help("my-hills"), "hills of mine");
  EXPECT_EQ(own.help("nobody"), "");
  EXPECT_TRUE(own.source("my-hills:z=1", {"band2"}).ok());
  EXPECT_FALSE(own.addGenerator("my-hills", "", factory).ok());
  EXPECT_FALSE(own.addGenerator("band2", "", factory).ok());
  for (const char* wrong : {"", "Hills", "my hills", "a:b", "a=b", "a,b", "\"a\""})
    EXPECT_FALSE(own.addGenerator(wrong, "", factory).ok()) << wrong;
  EXPECT_FALSE(own.addGenerator("empty", "", nullptr).ok());
}

TEST(TeGeneratorRegistry, FactoriesThatMakeNothingAreAnError) {
  TeGeneratorRegistry registry;
  ASSERT_TRUE(registry.addGenerator("empty", "makes none", [] { return std::unique_ptr<TeGenerator>(); }));
  ASSERT_TRUE(registry.addFilter("void", "makes none", [] { return std::unique_ptr<TeFilter>(); }));
  EXPECT_FALSE(registry.generator("empty"));
  EXPECT_FALSE(registry.filter("void"));
  EXPECT_NE(registry.helpText().find("makes none"), std::string::npos);
}

TEST(TeGeneratorRegistry, HelpListsEverythingWithItsRange) {
  const std::string help = registry().helpText();
  for (const std::string& name : registry().generatorNames())
    EXPECT_TRUE(contains(help, "\n  " + name + "  " + registry().help(name))) << name;
  EXPECT_TRUE(contains(help, "k=0.9  (a number, 0 to 1)"));
  EXPECT_TRUE(contains(help, "passes=5  (a whole number, 0 to 1000)"));
  std::vector<std::string> names = registry().generatorNames();
  for (const char* ours : {"faults", "midpoint", "circles", "function", "noise"})
    EXPECT_NE(std::find(names.begin(), names.end(), ours), names.end()) << ours;
}
