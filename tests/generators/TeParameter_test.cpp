#include "generators/TeParameter.h"

#include "generators/base/TeRandom.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace {

struct Parameters : testing::Test {
  double weight = 0.5;
  int count = 10;
  std::uint64_t seed = 1;
  bool smooth = true;
  std::string profile = "step";
  std::string text = "a";
  const TeParameters all = {{"weight", &weight, 0, 1, {}, "share"},
                            {"count", &count, 1, 100, {}, "how many"},
                            {"seed", &seed, 0, 0, {}, "seed"},
                            {"smooth", &smooth, 0, 0, {}, "whether"},
                            {"profile", &profile, 0, 0, {"step", "smooth"}, "kind"},
                            {"text", &text, 0, 0, {}, "anything"}};

  std::string errorOf(const char* name, const char* value) {
    const TeStatus status = teSetParameter(all, "owner", name, value);
    return status.ok() ? "" : status.error().message;
  }
};

using TeParameterTest = Parameters;

} // namespace

TEST_F(TeParameterTest, ValuesAreParsedWhole) {
  EXPECT_EQ(errorOf("weight", "0.25"), "");
  EXPECT_EQ(weight, 0.25);
  EXPECT_EQ(errorOf("weight", "1e-3"), "");
  EXPECT_EQ(weight, 1e-3);
  EXPECT_EQ(errorOf("count", "100"), "");
  EXPECT_EQ(count, 100);
  EXPECT_EQ(errorOf("seed", "18446744073709551615"), "");
  EXPECT_EQ(seed, UINT64_MAX);
  for (const char* no : {"false", "off", "no", "0"}) {
    smooth = true;
    EXPECT_EQ(errorOf("smooth", no), "");
    EXPECT_FALSE(smooth);
  }
  EXPECT_EQ(errorOf("profile", "smooth"), "");
  EXPECT_EQ(profile, "smooth");
  EXPECT_EQ(errorOf("text", "any thing, at all"), "");
  EXPECT_EQ(text, "any thing, at all");
}

TEST_F(TeParameterTest, WrongValuesAreErrorsAndStoreNothing) {
  EXPECT_EQ(errorOf("weight", "1.5"), "owner: weight is \"1.5\", must be a number, 0 to 1");
  EXPECT_EQ(errorOf("count", "2.5"), "owner: count is \"2.5\", must be a whole number, 1 to 100");
  EXPECT_EQ(errorOf("profile", "smoth"),
            "owner: profile is \"smoth\"; did you mean smooth? (known: step, smooth)");
  EXPECT_EQ(errorOf("smooth", "maybe"), "owner: smooth is \"maybe\", must be true|false");
  for (const char* wrong : {"", "nan", "inf", "-0.1", "0.5x", " 0.5", "0.5 ", "+0.5", "0,5", "1e999", "--1"})
    EXPECT_NE(errorOf("weight", wrong), "") << wrong;
  for (const char* wrong : {"", "0", "101", "-5", "1e1", "99999999999999999999", "nan", "0x10"})
    EXPECT_NE(errorOf("count", wrong), "") << wrong;
  for (const char* wrong : {"", "-1", "18446744073709551616", "1.0"})
    EXPECT_NE(errorOf("seed", wrong), "") << wrong;
  EXPECT_EQ(weight, 0.5);
  EXPECT_EQ(count, 10);
  EXPECT_EQ(seed, 1u);
  EXPECT_EQ(profile, "step");
}

TEST_F(TeParameterTest, UnknownNamesAreAnsweredWithTheNearest) {
  EXPECT_EQ(errorOf("wieght", "1"),
            "owner: unknown parameter \"wieght\"; did you mean weight? (known: weight, count, seed, smooth, "
            "profile, text)");
  EXPECT_NE(errorOf("", "1"), "");
  const std::string message = errorOf("a\nb\tc", "1");
  EXPECT_EQ(message.find('\n'), std::string::npos);
  EXPECT_LT(errorOf(std::string(10000, 'x').c_str(), "1").size(), 300u);
}

TEST_F(TeParameterTest, CheckFindsWhatAProgramSetWrongly) {
  EXPECT_TRUE(teCheckParameters(all, "owner").ok());
  weight = std::nan("");
  EXPECT_EQ(teCheckParameters(all, "owner").error().message,
            "owner: weight is \"nan\", must be a number, 0 to 1");
  weight = 0;
  count = 0;
  EXPECT_FALSE(teCheckParameters(all, "owner").ok());
  count = 1;
  profile = "round";
  EXPECT_FALSE(teCheckParameters(all, "owner").ok());
}

TEST_F(TeParameterTest, TextReadsBackToTheSameBits) {
  TeRandom random(1, 2, {});
  for (int i = 0; i < 20000; ++i) {
    const std::uint64_t bits = random.next();
    double number;
    std::memcpy(&number, &bits, sizeof number);
    if (!std::isfinite(number))
      continue;
    double value = number;
    const TeParameters any = {{"n", &value, -1.7976931348623157e308, 1.7976931348623157e308, {}, ""}};
    const std::string written = teParameterText(any[0]);
    value = 0;
    ASSERT_TRUE(teSetParameter(any, "", "n", written).ok()) << written;
    ASSERT_EQ(0, std::memcmp(&value, &number, sizeof value)) << written;
  }
  for (const TeParameter& parameter : all)
    EXPECT_TRUE(teSetParameter(all, "", parameter.name, teParameterText(parameter)).ok()) << parameter.name;
}

TEST_F(TeParameterTest, TheHashTellsValuesApart) {
  const std::uint64_t before = teHashParameters(all, 1);
  EXPECT_EQ(teHashParameters(all, 1), before);
  EXPECT_NE(teHashParameters(all, 2), before);
  const auto changes = [&](auto& member, auto value) {
    const auto old = member;
    member = value;
    EXPECT_NE(teHashParameters(all, 1), before);
    member = old;
    EXPECT_EQ(teHashParameters(all, 1), before);
  };
  changes(weight, std::nextafter(0.5, 1.0));
  changes(count, 11);
  changes(seed, std::uint64_t(1) << 63);
  changes(smooth, false);
  changes(profile, std::string("smooth"));
  changes(text, std::string());
}
