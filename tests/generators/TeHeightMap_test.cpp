#include "generators/TeHeightMap.h"

#include "tests/generators/TeTestSources.h"

#include <gtest/gtest.h>

#include <sys/resource.h>
#include <unistd.h>

#include <cfloat>
#include <cmath>
#include <cstring>
#include <functional>

namespace {

TeHeightMap ramp(int width, int height) {
  TeHeightMap map = TeHeightMap::create(width, height).value();
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      map.at(x, y) = float(y * 100 + x);
  return map;
}

} // namespace

TEST(TeHeightMap, SamplesLieRowByRowFromTheSouthWest) {
  const TeHeightMap map = ramp(5, 3);
  EXPECT_EQ(map.width(), 5);
  EXPECT_EQ(map.height(), 3);
  EXPECT_EQ(map.bytes(), 15 * sizeof(float));
  EXPECT_EQ(map.data()[2 * 5 + 4], 204.0f);
  EXPECT_EQ(map.row(1)[3], 103.0f);
  EXPECT_EQ(map.at(3, 1), 103.0f);
}

TEST(TeHeightMap, SizesThatCannotBeAreErrors) {
  for (const auto& [width, height] : {std::pair(0, 1), std::pair(1, 0), std::pair(-1, 5), std::pair(5, -1),
                                      std::pair(1 << 15, 1 << 14), std::pair(INT32_MAX, INT32_MAX)})
    EXPECT_FALSE(TeHeightMap::create(width, height).ok()) << width << "x" << height;
  EXPECT_TRUE(TeHeightMap::create(1, 1).ok());
  EXPECT_TRUE(TeHeightMap().empty());
  EXPECT_EQ(TeHeightMap().statistics().present, 0);
}

TEST(TeHeightMap, OperationsTouchExactlyTheirRectangle) {
  const TeHeightMap source = ramp(6, 5);
  const TeMapRect from = {1, 2, 3, 2};
  const TeMapRect to = {4, 3, 3, 2};
  using Operation = std::function<TeStatus(TeHeightMap&)>;
  using Expected = std::function<float(float, float)>;
  const std::pair<Operation, Expected> cases[] = {
      {[&](TeHeightMap& m) { return m.copy(source, from, to); }, [](float, float s) { return s; }},
      {[&](TeHeightMap& m) { return m.add(source, from, to); }, [](float d, float s) { return d + s; }},
      {[&](TeHeightMap& m) { return m.subtract(source, from, to); }, [](float d, float s) { return d - s; }},
      {[&](TeHeightMap& m) { return m.multiply(source, from, to); }, [](float d, float s) { return d * s; }},
      {[&](TeHeightMap& m) { return m.addScaled(source, 0.5f, from, to); },
       [](float d, float s) { return d + 0.5f * s; }},
      {[&](TeHeightMap& m) { return m.minimum(source, from, to); },
       [](float d, float s) { return std::min(d, s); }},
      {[&](TeHeightMap& m) { return m.maximum(source, from, to); },
       [](float d, float s) { return std::max(d, s); }},
      {[&](TeHeightMap& m) { return m.fill(7.5f, to); }, [](float, float) { return 7.5f; }},
      {[&](TeHeightMap& m) { return m.scale(-2.0f, to); }, [](float d, float) { return -2.0f * d; }},
  };
  for (const auto& [operation, expected] : cases) {
    const TeHeightMap before = teRandomMap(8, 6, 3);
    TeHeightMap map = before;
    ASSERT_TRUE(operation(map).ok());
    for (int y = 0; y < 6; ++y)
      for (int x = 0; x < 8; ++x) {
        const bool inside = x >= 4 && x < 7 && y >= 3 && y < 5;
        const float old = before.at(x, y);
        ASSERT_EQ(map.at(x, y), inside ? expected(old, source.at(x - 4 + 1, y - 3 + 2)) : old)
            << x << " " << y;
      }
  }
}

TEST(TeHeightMap, SourceAndDestinationMayOverlapInOneMap) {
  for (int dy = -2; dy <= 2; ++dy)
    for (int dx = -2; dx <= 2; ++dx) {
      const TeHeightMap before = ramp(12, 11);
      const TeMapRect from = {3, 3, 6, 5};
      const TeMapRect to = {3 + dx, 3 + dy, 6, 5};
      TeHeightMap copied = before;
      ASSERT_TRUE(copied.copy(copied, from, to).ok());
      TeHeightMap added = before;
      ASSERT_TRUE(added.add(added, from, to).ok());
      TeHeightMap expectedCopy = before;
      ASSERT_TRUE(expectedCopy.copy(before, from, to).ok());
      TeHeightMap expectedSum = before;
      ASSERT_TRUE(expectedSum.add(before, from, to).ok());
      EXPECT_TRUE(copied == expectedCopy) << dx << " " << dy;
      EXPECT_TRUE(added == expectedSum) << dx << " " << dy;
    }
}

TEST(TeHeightMap, RectanglesOutsideAreErrorsAndChangeNothing) {
  const TeHeightMap source = ramp(6, 5);
  const TeMapRect inside = {1, 1, 2, 2};
  const TeMapRect wrong[] = {{-1, 0, 2, 2},        {0, -1, 2, 2},        {5, 0, 2, 2},
                             {0, 4, 2, 2},         {0, 0, 0, 2},         {0, 0, 2, 0},
                             {0, 0, -1, 2},        {0, 0, 7, 2},         {INT32_MAX, 0, 2, 2},
                             {0, INT32_MAX, 2, 2}, {2, 2, INT32_MAX, 2}, {INT32_MIN, INT32_MIN, 2, 2}};
  for (const TeMapRect& rect : wrong) {
    TeHeightMap map = ramp(6, 5);
    const TeHeightMap before = map;
    for (const TeStatus& status :
         {map.copy(source, rect, inside), map.copy(source, inside, rect), map.add(source, rect, inside),
          map.add(source, inside, rect), map.subtract(source, inside, rect),
          map.multiply(source, rect, inside), map.addScaled(source, 2, inside, rect),
          map.minimum(source, rect, inside), map.maximum(source, inside, rect), map.fill(1, rect),
          map.scale(2, rect)}) {
      ASSERT_FALSE(status.ok());
      EXPECT_NE(status.error().message.find("rectangle"), std::string::npos) << status.error().message;
    }
    EXPECT_FALSE(map.statistics(rect).ok());
    EXPECT_TRUE(map == before);
  }
  TeHeightMap map = ramp(6, 5);
  const TeStatus differing = map.copy(source, {0, 0, 2, 3}, {0, 0, 3, 2});
  ASSERT_FALSE(differing.ok());
  EXPECT_NE(differing.error().message.find("differ in size"), std::string::npos);
  EXPECT_FALSE(TeHeightMap().fill(1, {0, 0, 1, 1}).ok());
}

TEST(TeHeightMap, StatisticsCountWhatIsThere) {
  TeHeightMap map = ramp(5, 4);
  EXPECT_EQ(map.statistics().minimum, 0);
  EXPECT_EQ(map.statistics().maximum, 304);
  EXPECT_EQ(map.statistics().mean, 152);
  EXPECT_EQ(map.statistics().present, 20);
  map.at(0, 0) = TeHeightMap::missing();
  map.at(4, 3) = TeHeightMap::missing();
  const TeMapStatistics all = map.statistics();
  EXPECT_EQ(all.minimum, 1);
  EXPECT_EQ(all.maximum, 303);
  EXPECT_EQ(all.present, 18);
  EXPECT_EQ(all.missing, 2);
  const TeMapStatistics part = map.statistics({1, 1, 2, 2}).value();
  EXPECT_EQ(part.minimum, 101);
  EXPECT_EQ(part.maximum, 202);
  EXPECT_EQ(part.mean, 151.5);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 5; ++x)
      map.at(x, y) = TeHeightMap::missing();
  EXPECT_EQ(map.statistics().present, 0);
  EXPECT_EQ(map.statistics().mean, 0);
  EXPECT_EQ(map.statistics().minimum, 0);
}

TEST(TeHeightMap, ShiftsBringTheLevelWhereItIsWanted) {
  TeHeightMap map = teRandomMap(65, 65, 8);
  tePunchHoles(map, 2, 10);
  const TeMapStatistics before = map.statistics();
  map.shift(12.5f);
  EXPECT_NEAR(map.statistics().mean, before.mean + 12.5, 1e-4);
  EXPECT_EQ(map.statistics().missing, before.missing);
  map.shiftMinimumTo(3.0f);
  EXPECT_NEAR(map.statistics().minimum, 3.0, 1e-4);
  map.shiftMeanTo(-7.0f);
  EXPECT_NEAR(map.statistics().mean, -7.0, 1e-4);
}

TEST(TeHeightMap, MissingStaysMissingUntilItIsFilled) {
  TeHeightMap map = ramp(4, 4);
  map.at(2, 2) = TeHeightMap::missing();
  TeHeightMap other = ramp(4, 4);
  ASSERT_TRUE(other.add(map, map.bounds(), map.bounds()).ok());
  EXPECT_TRUE(TeHeightMap::isMissing(other.at(2, 2)));
  ASSERT_TRUE(other.maximum(ramp(4, 4), map.bounds(), map.bounds()).ok());
  EXPECT_TRUE(TeHeightMap::isMissing(other.at(2, 2)));
  other.shift(100);
  EXPECT_TRUE(TeHeightMap::isMissing(other.at(2, 2)));
  EXPECT_TRUE(other.hasMissing());
  other.fillMissing(-1);
  EXPECT_FALSE(other.hasMissing());
  EXPECT_EQ(other.at(2, 2), -1);
  ASSERT_TRUE(other.fill(FLT_MAX, other.bounds()).ok());
  ASSERT_TRUE(other.scale(2, other.bounds()).ok());
  EXPECT_EQ(other.statistics().missing, 16) << "overflow is a missing sample, not infinity";
}

TEST(TeHeightMap, EqualityIsBitForBit) {
  TeHeightMap a = ramp(3, 3);
  TeHeightMap b = a;
  a.at(0, 0) = 0.0f;
  b.at(0, 0) = -0.0f;
  EXPECT_TRUE(a != b);
  a.at(0, 0) = b.at(0, 0) = TeHeightMap::missing();
  EXPECT_TRUE(a == b);
  EXPECT_TRUE(ramp(2, 8) != ramp(8, 2));
  EXPECT_TRUE(TeHeightMap() == TeHeightMap());
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) // which take address space of their own
TEST(TeHeightMapDeathTest, NotEnoughMemoryIsAnError) {
  const auto inLittleMemory = [] {
    const rlimit limit{rlim_t(1) << 30, rlim_t(1) << 30};
    ::setrlimit(RLIMIT_AS, &limit);
    const TeResult<TeHeightMap> map = TeHeightMap::create(16384, 16384);
    const TeHeightMap small = TeHeightMap::create(16, 16).value();
    const bool right = !map && map.error().message == "map size 16384x16384: not enough memory";
    ::_exit(right && small.width() == 16 ? 0
                                         : 1); // without destructors, which would remove files of the tests
  };
  EXPECT_EXIT(inLittleMemory(), testing::ExitedWithCode(0), "");
}
#endif
