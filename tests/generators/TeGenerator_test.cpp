#include "generators/TeGenerator.h"

#include "generators/TeFilterChain.h"
#include "generators/TeGeneratorRegistry.h"
#include "generators/filters/TeBandFilter.h"
#include "generators/function/TeFunctionGenerator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <new>

namespace {

TeMapRequest request(int side) { return TeMapRequest::standalone(side, side, 1, 0).value(); }

TeMapRequest sized(int columns, int rows) {
  TeMapRequest request;
  request.columns = columns;
  request.rows = rows;
  return request;
}

/// A source that needs more memory than there is.
class Greedy final : public TePointSource {
public:
  std::string name() const override { return "greedy"; }
  std::uint64_t fingerprint() const override { return 1; }
  TeStatus evaluate(const TeMapRequest&, const TeMapSample*, std::size_t, float*) const override {
    throw std::bad_alloc();
  }
};

} // namespace

TEST(TeGenerator, MakesAMapInSlices) {
  TeFunctionGenerator generator;
  generator.z = "x + 100*y";
  ASSERT_TRUE(generator.start(request(20)).ok());
  int slices = 0;
  for (TeAllowance one = TeAllowance::units(1); !generator.genStep(one); one = TeAllowance::units(1))
    ++slices;
  EXPECT_GT(slices, 5);
  EXPECT_EQ(generator.progress(), TeProgress::Done);
  const TeHeightMap map = generator.takeMap();
  EXPECT_EQ(map.at(3, 4), 403.0f);
}

TEST(TeGenerator, ParametersChangedDuringAJobTakeEffectWithTheNext) {
  TeFunctionGenerator generator;
  generator.z = "1";
  ASSERT_TRUE(generator.start(request(10)).ok());
  TeAllowance one = TeAllowance::units(1);
  EXPECT_FALSE(generator.genStep(one));
  generator.z = "2";
  ASSERT_TRUE(generator.generate().ok());
  const TeHeightMap first = generator.takeMap();
  EXPECT_EQ(first.statistics().minimum, 1);
  EXPECT_EQ(first.statistics().maximum, 1);
  ASSERT_TRUE(generator.start(request(10)).ok());
  ASSERT_TRUE(generator.generate().ok());
  EXPECT_EQ(generator.takeMap().statistics().mean, 2);
}

TEST(TeGenerator, BadParametersKeepTheFormerSourceAndJob) {
  TeFunctionGenerator generator;
  generator.z = "1";
  ASSERT_TRUE(generator.start(request(10)).ok());
  const TeHeightSourcePtr source = generator.source();
  generator.z = "1 +";
  EXPECT_FALSE(generator.updateParams().ok());
  EXPECT_EQ(generator.source(), source);
  EXPECT_FALSE(generator.start(request(10)).ok());
  EXPECT_EQ(generator.source(), source);
  ASSERT_TRUE(generator.generate().ok());
  EXPECT_EQ(generator.takeMap().statistics().mean, 1);
}

TEST(TeGenerator, CallsInABadOrderAreAnswered) {
  TeFunctionGenerator generator;
  EXPECT_EQ(generator.source(), nullptr);
  EXPECT_EQ(generator.progress(), TeProgress::Done);
  TeAllowance one = TeAllowance::units(1);
  EXPECT_TRUE(generator.genStep(one));
  const TeStatus early = generator.generate();
  ASSERT_FALSE(early.ok());
  EXPECT_EQ(early.error().message, "function: generate() before start()");
  ASSERT_TRUE(generator.start(request(3)).ok());
  ASSERT_TRUE(generator.generate().ok());
  ASSERT_TRUE(generator.generate().ok());
  EXPECT_EQ(generator.takeMap().width(), 3);
  EXPECT_FALSE(generator.generate().ok());
}

TEST(TeGenerator, RequestsThatCannotBeAreErrors) {
  TeFunctionGenerator generator;
  for (const TeMapRequest& wrong :
       {sized(0, 5), sized(5, 0), sized(-5, 5), sized(1 << 20, 1 << 20), sized(INT32_MAX, INT32_MAX)}) {
    const TeStatus status = generator.start(wrong);
    ASSERT_FALSE(status.ok());
    EXPECT_EQ(status.error().message.rfind("function: map size", 0), 0u) << status.error().message;
  }
  TeMapRequest wrong = sized(5, 5);
  for (double spacing : {0.0, -1.0, double(NAN), double(INFINITY)}) {
    wrong.spacing = spacing;
    EXPECT_FALSE(generator.start(wrong).ok());
  }
}

TEST(TeGenerator, AChainIsOneGeneratorWithAllParameters) {
  std::vector<std::unique_ptr<TeFilter>> filters;
  filters.push_back(std::make_unique<TeBandFilter>());
  filters.push_back(std::make_unique<TeBandFilter>());
  TeFilterChain chain(std::make_unique<TeFunctionGenerator>(), std::move(filters));
  EXPECT_EQ(chain.name(), "function+band+band");
  std::vector<std::string> names;
  for (const TeParameter& parameter : chain.parameters())
    names.push_back(parameter.name);
  EXPECT_EQ(names, (std::vector<std::string>{"z", "band.k", "band.passes", "band2.k", "band2.passes"}));
  ASSERT_TRUE(teSetParameter(chain.parameters(), chain.name(), "band2.k", "0.25").ok());
  EXPECT_EQ(static_cast<TeBandFilter&>(chain.filter(1)).k, 0.25);

  ASSERT_TRUE(chain.start(request(9)).ok());
  ASSERT_TRUE(chain.generate().ok());
  const TeHeightMap map = chain.takeMap();
  const auto same = TeGeneratorRegistry::instance().source("function", {"band", "band:k=0.25"}).value();
  EXPECT_TRUE(map == same->generate(request(9)).value());
  EXPECT_EQ(chain.source()->fingerprint(), same->fingerprint());

  static_cast<TeBandFilter&>(chain.filter(0)).passes = -1;
  EXPECT_FALSE(chain.updateParams().ok());
  EXPECT_EQ(chain.source()->fingerprint(), same->fingerprint());
}

TEST(TeHeightJob, FailsWhenMemoryRunsOut) {
  const auto source = std::make_shared<Greedy>();
  const TeResult<TeHeightMap> map = source->generate(request(20));
  ASSERT_FALSE(map);
  EXPECT_NE(map.error().message.find("memory"), std::string::npos) << map.error().message;
  // Also where it is the input of another job.
  TeBandFilter filter;
  EXPECT_FALSE((*filter.apply(source))->generate(request(20)));
}
