#include "nodes/clipmap/TeClipWindows.h"

#include "generators/base/TeRandom.h"
#include "nodes/clipmap/testPyramid.h"
#include "nodes/logLines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

namespace {

std::unique_ptr<TeClipWindows> makeWindows(const TestPyramid& pyramid, int size, int maxLevel = -1) {
  auto windows = TeClipWindows::create(pyramid.tiles(TeClipWindows::wholeLevel(size)), size, maxLevel);
  if (!windows) {
    ADD_FAILURE() << windows.error().message;
    return nullptr;
  }
  return std::move(*windows);
}

/// Samples in resident windows that are missing or wrong; all of them, or each `step`-th.
int wrongSamples(const TestPyramid& pyramid, const TeClipWindows& windows, int step = 1) {
  int wrong = 0;
  const TeClipResidency& residency = windows.residency();
  for (int level = residency.base; level <= residency.top(); level++) {
    const TeClipWindow& window = residency.windows[std::size_t(level - residency.base)];
    for (std::int32_t y = window.y; y < window.y + window.side; y += step)
      for (std::int32_t x = window.x; x < window.x + window.side; x += step) {
        const unsigned char* bytes = windows.sample(level, x, y);
        wrong += !bytes || !pyramid.isSample(bytes, level, x, y);
      }
  }
  return wrong;
}

/// Every window lies in the level and in the window below, and has one below.
bool areNested(const TeClipResidency& residency) {
  for (std::size_t i = 1; i < residency.windows.size(); i++) {
    const TeClipWindow& inner = residency.windows[i];
    const TeClipWindow& outer = residency.windows[i - 1];
    if (inner.side == 0)
      continue;
    if (outer.side == 0)
      return false;
    const int side = tePyramidSide(residency.base + int(i));
    if (inner.x < 0 || inner.y < 0 || inner.x + inner.side > side || inner.y + inner.side > side)
      return false;
    if (inner.x < 2 * outer.x || inner.y < 2 * outer.y ||
        inner.x + inner.side - 1 > 2 * (outer.x + outer.side - 1) ||
        inner.y + inner.side - 1 > 2 * (outer.y + outer.side - 1))
      return false;
  }
  return true;
}

int residentLevels(const TeClipResidency& residency) {
  return int(std::count_if(residency.windows.begin(), residency.windows.end(),
                           [](const TeClipWindow& window) { return window.side > 0; }));
}

std::int64_t pendingSamples(const TeClipWindows& windows) {
  std::int64_t samples = 0;
  for (const TeClipUpload& upload : windows.uploads())
    samples += upload.texels.count();
  return samples;
}

/// Main memory of this process.
long residentBytes() {
  long pages = 0;
  long resident = 0;
  std::ifstream("/proc/self/statm") >> pages >> resident;
  return resident * ::sysconf(_SC_PAGESIZE);
}

/// A walk with steps of all sizes, over the rim too, and a jump now and then.
class Walk {
public:
  Walk(std::uint64_t seed, int level) : m_random(seed, 1, {}), m_side(std::ldexp(1.0, level)) { jump(); }
  glm::dvec2 next() {
    if (m_random.below(25) == 0)
      jump();
    const double reach = std::ldexp(1.0, int(m_random.below(6)) - 2);
    m_at += glm::dvec2(m_random.uniform(-reach, reach), m_random.uniform(-reach, reach));
    return m_at;
  }

private:
  void jump() { m_at = {m_random.uniform(-0.2, 1.2) * m_side, m_random.uniform(-0.2, 1.2) * m_side}; }
  TeRandom m_random;
  double m_side;
  glm::dvec2 m_at{0};
};

} // namespace

TEST(TeClipWindows, AllLevelsAreResidentAroundTheCentreAfterOneUpdateWithoutABudget) {
  const TestPyramid pyramid(8);
  const auto windows = makeWindows(pyramid, 33);
  ASSERT_TRUE(windows);
  EXPECT_EQ(windows->baseLevel(), 5);
  EXPECT_EQ(windows->topLevel(), 8);
  EXPECT_EQ(residentLevels(windows->residency()), 1) << "the base is there from the beginning";
  windows->update({100, 60}, 8, 0);
  EXPECT_TRUE(windows->isSettled());
  const TeClipResidency& residency = windows->residency();
  EXPECT_EQ(residentLevels(residency), 4);
  EXPECT_TRUE(residency.holds(8, 100 - 16, 60 - 16, 100 + 16, 60 + 16));
  EXPECT_TRUE(residency.holds(7, 50 - 16, 30 - 16, 50 + 16, 30 + 16));
  EXPECT_TRUE(residency.holds(6, 25 - 16, 0, 25 + 16, 31));
  EXPECT_TRUE(residency.holds(5, 0, 0, 32, 32));
  EXPECT_TRUE(residency.holds(2, 0, 0, 4, 4));
  EXPECT_FALSE(residency.holds(8, 100 - 17, 60, 100, 60));
  EXPECT_EQ(wrongSamples(pyramid, *windows), 0);
  EXPECT_EQ(windows->height(2, 3, 1), pyramid.sample(2, 3, 1)) << "below the base";
  EXPECT_EQ(windows->sample(8, 5, 60), nullptr);
  EXPECT_EQ(windows->sample(9, 5, 60), nullptr);
}

TEST(TeClipWindows, WhatIsResidentIsRightAndNestedOnEveryWalk) {
  for (const int bytes : {2, 3, 4}) {
    const TestPyramid pyramid(8, bytes);
    for (const int size : {5, 12, 33, 40}) {
      for (const std::size_t budget : {0u, 1u, 150u, 1000u, 4000u}) {
        const auto windows = makeWindows(pyramid, size);
        ASSERT_TRUE(windows);
        const std::int64_t most = std::max<std::int64_t>(std::int64_t(budget) / bytes, windows->side());
        Walk walk(std::uint64_t(size) * 10000 + budget, 8);
        windows->clearUploads();
        for (int step = 0; step < 120; step++) {
          windows->update(walk.next(), 8, budget);
          ASSERT_EQ(wrongSamples(pyramid, *windows, 3), 0) << size << " " << budget << " " << step;
          ASSERT_TRUE(areNested(windows->residency())) << size << " " << budget << " " << step;
          if (budget > 0)
            ASSERT_LE(pendingSamples(*windows), most);
          else
            ASSERT_TRUE(windows->isSettled());
          windows->clearUploads();
        }
        // Standing still it comes to an end, however small the budget.
        const glm::dvec2 last = walk.next();
        windows->update(last, 8, budget);
        for (int updates = 0; updates < 20000 && !windows->isSettled(); updates++)
          windows->update(last, 8, budget);
        EXPECT_TRUE(windows->isSettled()) << size << " " << budget;
        EXPECT_EQ(residentLevels(windows->residency()), windows->levels());
        EXPECT_EQ(wrongSamples(pyramid, *windows), 0);
        windows->clearUploads();
        windows->update(last, 8, budget);
        EXPECT_TRUE(windows->uploads().empty()) << "nothing to do, nothing done";
      }
    }
  }
}

// What a texture would hold that gets the uploads and nothing else.
TEST(TeClipWindows, UploadsAreAllThatATextureNeeds) {
  const TestPyramid pyramid(8);
  for (const std::size_t budget : {0u, 300u, 2500u}) {
    const auto windows = makeWindows(pyramid, 20);
    ASSERT_TRUE(windows);
    std::vector<std::vector<unsigned char>> texture(std::size_t(windows->levels()));
    for (auto& layer : texture)
      layer.assign(windows->imageBytes(), 0xcc);
    Walk walk(budget, 8);
    for (int step = 0; step < 200; step++) {
      windows->update(walk.next(), 8, budget);
      for (const TeClipUpload& upload : windows->uploads()) {
        const TeSampleRect& texels = upload.texels;
        ASSERT_TRUE(texels.x >= 0 && texels.y >= 0 && texels.x + texels.columns <= windows->side() &&
                    texels.y + texels.rows <= windows->side());
        for (int y = 0; y < texels.rows; y++)
          std::copy_n(windows->samples(upload) + std::size_t(y) * windows->rowBytes(), texels.columns * 2,
                      texture[std::size_t(upload.level - windows->baseLevel())].begin() +
                          ((texels.y + y) * windows->side() + texels.x) * 2);
      }
      windows->clearUploads();
      const TeClipResidency& residency = windows->residency();
      int wrong = 0;
      for (int level = residency.base; level <= residency.top(); level++) {
        const TeClipWindow& window = residency.windows[std::size_t(level - residency.base)];
        for (std::int32_t y = window.y; y < window.y + window.side; y++)
          for (std::int32_t x = window.x; x < window.x + window.side; x++) {
            const int texel = y % windows->side() * windows->side() + x % windows->side();
            wrong += !pyramid.isSample(&texture[std::size_t(level - residency.base)][std::size_t(2 * texel)],
                                       level, x, y);
          }
      }
      ASSERT_EQ(wrong, 0) << step;
    }
  }
}

TEST(TeClipWindows, AMoveUploadsNewRowsAndColumnsOnly) {
  const TestPyramid pyramid(9);
  const auto windows = makeWindows(pyramid, 65);
  ASSERT_TRUE(windows);
  const glm::dvec2 directions[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}};
  double worst = 0;
  for (const glm::dvec2& direction : directions) {
    glm::dvec2 centre = glm::dvec2(256) - 40.0 * direction;
    windows->update(centre, 9, 0);
    windows->clearUploads();
    std::int64_t uploaded = 0;
    std::int64_t ideal = 0;
    for (int move = 0; move < 80; move++) {
      const TeClipResidency before = windows->residency();
      centre += direction;
      windows->update(centre, 9, 0);
      for (std::size_t i = 1; i < before.windows.size(); i++) {
        const TeClipWindow& from = before.windows[i];
        const TeClipWindow& to = windows->residency().windows[i];
        const int columns = std::abs(to.x - from.x);
        const int rows = std::abs(to.y - from.y);
        ASSERT_LE(columns, 1);
        ASSERT_LE(rows, 1);
        ideal += 65 * (columns + rows) - columns * rows;
      }
      // Columns and rows of each of the three levels, each cut by the border once, and a corner twice.
      EXPECT_LE(windows->uploads().size(), 3u * 4u);
      uploaded += pendingSamples(*windows);
      windows->clearUploads();
    }
    EXPECT_GE(ideal, 80 * 65);
    worst = std::max(worst, double(uploaded) / double(ideal));
    std::printf("80 moves by (%g, %g): %lld bytes, ideally %lld\n", direction.x, direction.y,
                static_cast<long long>(2 * uploaded), static_cast<long long>(2 * ideal));
  }
  EXPECT_DOUBLE_EQ(worst, 1);
}

TEST(TeClipWindows, AfterAJumpCoarseLevelsComeFirstWithinTheBudget) {
  const TestPyramid pyramid(9);
  const auto windows = makeWindows(pyramid, 65);
  ASSERT_TRUE(windows);
  windows->update({60, 60}, 9, 0);
  EXPECT_EQ(residentLevels(windows->residency()), 4);
  windows->clearUploads();
  constexpr std::size_t kBudget = 3000;    // a window has 8450
  windows->update({460, 470}, 9, kBudget); // as if in flight at that speed
  EXPECT_EQ(pendingSamples(*windows), 0);
  int resident = 1;
  int updates = 1;
  std::int64_t samples = 0;
  do {
    windows->update({460, 470}, 9, kBudget);
    const int now = residentLevels(windows->residency());
    EXPECT_GE(now, resident) << "detail comes back from coarse to fine";
    resident = now;
    updates++;
    EXPECT_LE(2 * pendingSamples(*windows), std::int64_t(kBudget));
    samples += pendingSamples(*windows);
    windows->clearUploads();
  } while (updates < 100 && !windows->isSettled());
  EXPECT_EQ(resident, 4);
  EXPECT_EQ(wrongSamples(pyramid, *windows), 0);
  EXPECT_LE(samples, 3 * 65 * 65) << "nothing twice";
  std::printf("%d updates of %zu bytes after a jump: %lld bytes\n", updates, kBudget,
              static_cast<long long>(2 * samples));
}

TEST(TeClipWindows, UnderFastMotionCoarseLevelsStay) {
  const TestPyramid pyramid(10);
  const auto windows = makeWindows(pyramid, 65);
  ASSERT_TRUE(windows);
  glm::dvec2 centre(100, 500);
  windows->update(centre, 10, 0);
  ASSERT_EQ(residentLevels(windows->residency()), 5);
  // 8 samples of the finest level an update: windows of 65 need 4, 2, 1, 0.5 lines of 8 to 10 for less
  // than 7.
  constexpr std::size_t kBudget = 65 * 2 * 7;
  int least = 5;
  for (int step = 0; step < 90; step++) {
    centre.x += 8;
    windows->clearUploads();
    windows->update(centre, 10, kBudget);
    EXPECT_LE(2 * pendingSamples(*windows), std::int64_t(kBudget));
    EXPECT_EQ(wrongSamples(pyramid, *windows, 5), 0);
    least = std::min(least, residentLevels(windows->residency()));
    if (step > 40) {
      EXPECT_TRUE(
          windows->residency().holds(9, std::int32_t(centre.x / 2), 250, std::int32_t(centre.x / 2), 250));
    }
  }
  EXPECT_EQ(least, 4) << "all but the finest";
  for (int step = 0; step < 40; step++)
    windows->update(centre, 10, kBudget);
  EXPECT_EQ(residentLevels(windows->residency()), 5) << "it comes back when the viewer stops";
}

TEST(TeClipWindows, ALevelThatCannotBeReadIsReportedOnceAndNotUsed) {
  const TestPyramid pyramid(8);
  const auto windows = makeWindows(pyramid, 33);
  ASSERT_TRUE(windows);
  const LogLines log;
  windows->update({200, 200}, 8, 0);
  EXPECT_EQ(residentLevels(windows->residency()), 4);
  pyramid.resize(7, 129 * 20 * 2); // the south is lost while the program runs
  Walk walk(1, 8);
  for (int step = 0; step < 50; step++) {
    windows->update(walk.next(), 8, 0);
    ASSERT_EQ(wrongSamples(pyramid, *windows), 0);
  }
  EXPECT_EQ(residentLevels(windows->residency()), 2);
  EXPECT_FALSE(windows->residency().holds(8, 100, 100, 100, 100));
  EXPECT_TRUE(windows->isSettled()) << "there is nothing to wait for";
  EXPECT_THAT(log.lines,
              testing::ElementsAre(testing::AllOf(testing::HasSubstr(pyramid.file(7)),
                                                  testing::HasSubstr("level 6 stands for level 7"))));
}

TEST(TeClipWindows, ABaseThatCannotBeReadIsAnError) {
  const TestPyramid pyramid(8);
  const auto tiles = pyramid.tiles(5);
  pyramid.resize(5, 100);
  const auto windows = TeClipWindows::create(tiles, 33);
  ASSERT_FALSE(windows);
  EXPECT_THAT(windows.error().message, testing::HasSubstr(pyramid.file(5)));
}

TEST(TeClipWindows, UploadsThatNobodyFetchesStayBounded) {
  const TestPyramid pyramid(8);
  const auto windows = makeWindows(pyramid, 9);
  ASSERT_TRUE(windows);
  Walk walk(3, 8);
  for (int step = 0; step < 3000; step++) {
    windows->update(walk.next(), 8, 0);
    ASSERT_LE(windows->uploads().size(), 1024u);
  }
  std::vector<bool> whole(std::size_t(windows->levels()));
  for (const TeClipUpload& upload : windows->allUploads())
    whole[std::size_t(upload.level - windows->baseLevel())] = upload.texels.count() == 9 * 9;
  EXPECT_EQ(whole, std::vector<bool>(std::size_t(windows->levels()), true));
}

TEST(TeClipWindows, ATerrainSmallerThanTheWindowIsHeldWhole) {
  const TestPyramid pyramid(4);
  const auto windows = makeWindows(pyramid, 513);
  ASSERT_TRUE(windows);
  EXPECT_EQ(windows->levels(), 1);
  EXPECT_EQ(windows->side(), 17);
  EXPECT_EQ(windows->imageBytes(), 17u * 17u * 2u);
  EXPECT_TRUE(windows->isSettled());
  EXPECT_TRUE(windows->residency().holds(4, 0, 0, 16, 16));
  EXPECT_EQ(pendingSamples(*windows), 17 * 17);
  windows->clearUploads();
  windows->update({3, 3}, 4, 0);
  EXPECT_TRUE(windows->uploads().empty());
  EXPECT_EQ(wrongSamples(pyramid, *windows), 0);
}

TEST(TeClipWindows, LevelsAboveTheHighestAreNotHeld) {
  const TestPyramid pyramid(8);
  const auto windows = makeWindows(pyramid, 33, 6);
  ASSERT_TRUE(windows);
  EXPECT_EQ(windows->topLevel(), 6);
  windows->update({128, 128}, 8, 0);
  EXPECT_TRUE(windows->residency().holds(6, 16, 16, 48, 48)) << "the centre is in samples of level 8";
  EXPECT_FALSE(windows->residency().holds(7, 64, 64, 64, 64));
}

TEST(TeClipWindows, AHighestLevelBelowTheWholeOneIsTheBase) {
  for (const int bytes : {2, 3}) {
    const TestPyramid pyramid(8, bytes);
    const auto windows = makeWindows(pyramid, 65, 4);
    ASSERT_TRUE(windows);
    EXPECT_EQ(windows->baseLevel(), 4);
    EXPECT_EQ(windows->levels(), 1);
    EXPECT_EQ(windows->side(), 17);
    windows->update({7, 7}, 4, 0);
    EXPECT_TRUE(windows->isSettled());
    EXPECT_TRUE(windows->residency().holds(4, 0, 0, 16, 16));
    EXPECT_FALSE(windows->residency().holds(5, 0, 0, 1, 1));
    EXPECT_EQ(wrongSamples(pyramid, *windows), 0);
  }
}

TEST(TeClipWindows, CentresOutsideOrNowhere) {
  const TestPyramid pyramid(8);
  const auto windows = makeWindows(pyramid, 33);
  ASSERT_TRUE(windows);
  windows->update({-1e300, 1e300}, 8, 0);
  EXPECT_TRUE(windows->residency().holds(8, 0, 224, 32, 256)) << "the corner next to it";
  windows->clearUploads();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const glm::dvec2& centre : {glm::dvec2(nan, 0), glm::dvec2(0, infinity), glm::dvec2(-infinity, nan)})
    windows->update(centre, 8, 0);
  EXPECT_TRUE(windows->uploads().empty());
  EXPECT_EQ(residentLevels(windows->residency()), 4);
}

TEST(TeClipWindows, SizesThatDoNotWorkAreErrors) {
  const TestPyramid pyramid(6);
  const auto tiles = pyramid.tiles(4);
  const auto errorOf = [&](int size, int top) {
    const auto windows = TeClipWindows::create(tiles, size, top);
    return windows ? std::string() : windows.error().message;
  };
  for (const int size : {std::numeric_limits<int>::min(), -5, 0, 4, 8194, std::numeric_limits<int>::max()})
    EXPECT_THAT(errorOf(size, -1), testing::HasSubstr(std::to_string(size)));
  EXPECT_THAT(errorOf(9, -1), testing::HasSubstr("not whole"));
  EXPECT_THAT(errorOf(33, -1), testing::HasSubstr("level 5"));
  EXPECT_EQ(errorOf(17, 4), "");
  EXPECT_EQ(errorOf(17, 99), "");
  EXPECT_EQ(TeClipWindows::wholeLevel(513), 9);
  EXPECT_EQ(TeClipWindows::wholeLevel(512), 8);
  EXPECT_EQ(TeClipWindows::wholeLevel(5), 2);
}

// The document's pyramid: 16385 × 16385 samples, 682 MB of files (here with holes, which take no room on
// disk).
TEST(TeClipWindows, TheMemoryOfALargePyramidIsThatOfTheCacheAndTheWindows) {
  const TestPyramid folder(0);
  for (int level = 1; level <= 14; level++) {
    std::ofstream(folder.file(level)).close();
    folder.resize(level, TePyramidReader::levelBytes(level, 2));
  }
  const long before = residentBytes();
  const auto tiles = folder.tiles(9);
  auto made = TeClipWindows::create(tiles, 513);
  ASSERT_TRUE(made);
  TeClipWindows& windows = **made;
  EXPECT_EQ(windows.levels(), 6);
  for (int step = 0; step <= 64; step++) {
    windows.update({256.0 * step, 16384 - 240.0 * step}, 14, 0);
    ASSERT_LE(tiles->bytesHeld(), TePyramidTiles::kDefaultCacheBytes);
  }
  const double megabytes = double(residentBytes() - before) / 1e6;
  std::printf("flown over 16385 samples: %.1f MB of windows, %.1f MB of tiles, %.1f MB more in memory\n",
              6 * double(windows.imageBytes()) / 1e6, double(tiles->bytesHeld()) / 1e6, megabytes);
  EXPECT_NEAR(6 * double(windows.imageBytes()), 3.2e6, 0.1e6);
  EXPECT_LT(megabytes, 40);
  EXPECT_EQ(residentLevels(windows.residency()), 6);
}
