#include "nodes/clipmap/TeClipWindows.h"

#include "generators/base/TeLog.h"
#include "generators/base/TeRandom.h"
#include "nodes/clipmap/testPyramid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

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
