#include "tests/generators/TeEveryGenerator.h"

#include "generators/base/TeRandom.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>

namespace {

TeHeightSourcePtr make(const TeChainUnderTest& chain) {
  TeResult<TeHeightSourcePtr> source = TeGeneratorRegistry::instance().source(chain.generator, chain.filters);
  EXPECT_TRUE(source.ok()) << chain.name() << ": " << source.error().message;
  return source.ok() ? *source : nullptr;
}

constexpr int kSide = 33; // 2^n + 1, so that every generator makes it
const TeLattice kLattice = TeLattice::create(kSide, 7.5).value();
constexpr std::uint64_t kSeed = 2007;

TeHeightMap mapOf(const TeHeightSourcePtr& source, TeMapKey key) {
  return source->generate(TeMapRequest::sourceMap(kLattice, kSeed, key)).value();
}

const TeMapKey kKeys[] = {{0, 0}, {1, 0}, {0, 1}, {-1, -1}, {2, 3}, {(std::int64_t(1) << 40) + 5, -7}};

class EveryGenerator : public testing::TestWithParam<TeChainUnderTest> {};

} // namespace

INSTANTIATE_TEST_SUITE_P(Registry, EveryGenerator, testing::ValuesIn(teEveryGenerator()),
                         [](const auto& info) { return info.param.name(); });

TEST_P(EveryGenerator, IsPure) {
  const TeHeightSourcePtr one = make(GetParam());
  const TeHeightSourcePtr other = make(GetParam());
  ASSERT_TRUE(one && other);
  EXPECT_EQ(one->fingerprint(), other->fingerprint());
  EXPECT_EQ(one->name(), other->name());
  std::vector<TeHeightMap> maps;
  for (const TeMapKey& key : kKeys)
    maps.push_back(mapOf(one, key));
  for (std::size_t i = std::size(kKeys); i-- > 0;) {
    EXPECT_EQ(maps[i].width(), kSide);
    EXPECT_EQ(maps[i].height(), kSide);
    EXPECT_TRUE(maps[i] == mapOf(other, kKeys[i])) << kKeys[i].x << " " << kKeys[i].y;
    EXPECT_TRUE(maps[i] == mapOf(one, kKeys[i]));
  }
}

TEST_P(EveryGenerator, AnySlicingGivesTheSameBits) {
  const TeHeightSourcePtr source = make(GetParam());
  ASSERT_TRUE(source);
  const TeMapRequest request = TeMapRequest::sourceMap(kLattice, kSeed, {3, -2});
  const TeHeightMap expected = source->generate(request).value();
  TeRandom random(1, 1, {});
  const auto units = {
      std::function<std::int64_t()>([] { return 1; }), std::function<std::int64_t()>([] { return 7; }),
      std::function<std::int64_t()>([&random] { return 1 + std::int64_t(random.below(20)); })};
  for (const auto& next : units) {
    // A second job of the same source runs between the slices.
    const auto job = source->start(request);
    const auto disturbing = source->start(TeMapRequest::sourceMap(kLattice, kSeed, {-9, 4}));
    int slices = 0;
    while (job->progress() == TeProgress::Working && slices < 10000000) {
      TeAllowance allowance = TeAllowance::units(next());
      job->step(allowance);
      TeAllowance one = TeAllowance::units(1);
      disturbing->step(one);
      ++slices;
    }
    ASSERT_EQ(job->progress(), TeProgress::Done);
    EXPECT_TRUE(job->takeMap() == expected);
  }
}

TEST_P(EveryGenerator, PointsHaveTheBitsOfTheMap) {
  const TeHeightSourcePtr source = make(GetParam());
  ASSERT_TRUE(source);
  const TeMapRequest request = TeMapRequest::sourceMap(kLattice, kSeed, {-2, 5});
  std::vector<TeMapSample> samples;
  TeRandom random(3, 3, {});
  for (int i = 0; i < 500; ++i)
    samples.push_back({int(random.below(kSide)), int(random.below(kSide))});
  for (int corner : {0, kSide - 1})
    for (int other : {0, kSide - 1})
      samples.push_back({corner, other});
  std::vector<float> heights(samples.size());
  const TeStatus ok = source->evaluate(request, samples.data(), samples.size(), heights.data());
  EXPECT_EQ(ok.ok(), source->pointEvaluable());
  if (!source->pointEvaluable()) {
    EXPECT_NE(ok.error().message.find(source->name()), std::string::npos) << ok.error().message;
    return;
  }
  const TeHeightMap map = source->generate(request).value();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const float expected = map.at(samples[i].column, samples[i].row);
    ASSERT_EQ(0, std::memcmp(&expected, &heights[i], sizeof expected))
        << samples[i].column << " " << samples[i].row << ": " << expected << " " << heights[i];
  }
}

TEST_P(EveryGenerator, MapsAgreeWhereTheyOverlapIfItFits) {
  const TeHeightSourcePtr source = make(GetParam());
  ASSERT_TRUE(source);
  if (!source->fits())
    return; // maps of their own; blending joins them
  TeRandom random(8, 8, {});
  const int n = kLattice.cells();
  for (int i = 0; i < 8; ++i) {
    const int bits = i < 3 ? 2 : 41;
    const TeMapKey key = {
        std::int64_t(random.below(std::uint64_t(1) << bits)) - (std::int64_t(1) << (bits - 1)),
        std::int64_t(random.below(std::uint64_t(1) << bits)) - (std::int64_t(1) << (bits - 1))};
    TeHeightMap map = mapOf(source, key);
    for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(0, 1), std::pair(1, 1)}) {
      TeHeightMap next = mapOf(source, {key.x + dx, key.y + dy});
      const TeMapRect here = {dx * n, dy * n, kSide - dx * n, kSide - dy * n};
      const TeMapRect there = {0, 0, kSide - dx * n, kSide - dy * n};
      TeHeightMap a = TeHeightMap::create(here.width, here.height).value();
      TeHeightMap b = a;
      ASSERT_TRUE(a.copy(map, here, a.bounds()).ok());
      ASSERT_TRUE(b.copy(next, there, b.bounds()).ok());
      ASSERT_TRUE(a == b) << key.x << " " << key.y << " + " << dx << " " << dy;
    }
  }
}

TEST_P(EveryGenerator, HeightsAreFiniteOrMissingAndNotAllAlike) {
  const TeHeightSourcePtr source = make(GetParam());
  ASSERT_TRUE(source);
  const TeMapStatistics middle = mapOf(source, {0, 0}).statistics();
  EXPECT_LT(middle.minimum, middle.maximum);
  for (const TeMapKey& key : kKeys) {
    const TeHeightMap map = mapOf(source, key);
    const float missing = TeHeightMap::missing();
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < kSide; ++x)
        ASSERT_TRUE(std::isfinite(map.at(x, y)) ||
                    std::memcmp(&map.row(y)[x], &missing, sizeof missing) == 0);
  }
}

TEST_P(EveryGenerator, EqualFingerprintsMeanEqualMaps) {
  auto made = TeGeneratorRegistry::instance().chain(GetParam().generator, GetParam().filters);
  ASSERT_TRUE(made.ok());
  TeGenerator& generator = **made;
  ASSERT_TRUE(generator.updateParams().ok());
  const TeHeightSourcePtr original = generator.source();
  const TeHeightMap map = mapOf(original, {1, 2});
  for (const TeParameter& parameter : generator.parameters()) {
    const std::string before = teParameterText(parameter);
    std::vector<std::string> values = parameter.choices;
    if (std::holds_alternative<bool*>(parameter.value))
      values = {"true", "false"};
    else if (std::holds_alternative<std::uint64_t*>(parameter.value))
      values = {"0", "1", "18446744073709551615"};
    else if (double* const* value = std::get_if<double*>(&parameter.value))
      values = {std::to_string(0.5 * (**value + parameter.minimum)), std::to_string(parameter.minimum)};
    else if (int* const* value = std::get_if<int*>(&parameter.value))
      values = {std::to_string((**value + int(parameter.minimum)) / 2),
                std::to_string(int(parameter.minimum))};
    for (const std::string& value : values) {
      if (!teSetParameter({parameter}, "test", parameter.name, value).ok() || !generator.updateParams().ok())
        continue;
      if (generator.source()->fingerprint() == original->fingerprint() &&
          generator.source()->accepts(kSide, kSide).ok()) {
        EXPECT_TRUE(mapOf(generator.source(), {1, 2}) == map) << parameter.name << "=" << value;
      }
    }
    ASSERT_TRUE(teSetParameter({parameter}, "test", parameter.name, before).ok())
        << parameter.name << " " << before;
  }
  ASSERT_TRUE(generator.updateParams().ok());
  EXPECT_EQ(generator.source()->fingerprint(), original->fingerprint());
}

TEST_P(EveryGenerator, ParametersAreDescribedAndTheirDefaultsAreGood) {
  auto made = TeGeneratorRegistry::instance().chain(GetParam().generator, GetParam().filters);
  ASSERT_TRUE(made.ok());
  const TeParameters parameters = (*made)->parameters();
  EXPECT_TRUE(teCheckParameters(parameters, "test").ok());
  for (const TeParameter& parameter : parameters) {
    EXPECT_FALSE(parameter.help.empty()) << parameter.name;
    EXPECT_EQ(parameter.help.find('\n'), std::string::npos);
    EXPECT_LE(parameter.minimum, parameter.maximum) << parameter.name;
    // Every number out of range, and everything that is no number at all, is refused.
    if (std::holds_alternative<double*>(parameter.value) || std::holds_alternative<int*>(parameter.value)) {
      for (const char* wrong : {"nan", "inf", "-inf", "1e999", "", "1x", "x", " 1", "0x10"})
        EXPECT_FALSE(teSetParameter(parameters, "test", parameter.name, wrong).ok())
            << parameter.name << wrong;
    }
  }
}
