#include "engine/budget/TeFrameBudget.h"

#include "generators/base/TeRandom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

constexpr double kFrame = 1.0 / 60;

/// A program whose ticks use their budget up; frames take drawing + tick + rest, and with a display that
/// waits, whole frames.
struct Program {
  TeFrameBudget budget;
  double draw = 0.003;
  double rest = 0.002;
  double noise = 0;
  bool display = false;
  TeRandom random{1, 2, {}};
  int late = 0;

  Program() { EXPECT_TRUE(budget.setFrameRate(60)); }

  double runFrame() {
    const double factor = 1 + noise * random.uniform(-1.0, 1.0);
    const double tick = budget.budget();
    budget.tickDone(tick, 0.0002);
    double frame = draw * factor + tick + rest;
    if (display)
      frame = kFrame * std::ceil(frame / kFrame - 1e-9);
    late += frame > 1.02 * kFrame;
    budget.frameDrawn(frame, draw * factor);
    return budget.budget();
  }
  double run(int frames) {
    for (int i = 0; i < frames; ++i)
      runFrame();
    return budget.budget();
  }
};

} // namespace

TEST(TeFrameBudget, IsFixedWithoutAFrameRateAndRefusesTheImpossible) {
  TeFrameBudget budget;
  EXPECT_EQ(budget.budget(), TeFrameBudget::kDefault);
  for (double seconds : {0.0, -1.0, 1.1, HUGE_VAL, double(NAN)})
    EXPECT_FALSE(budget.setBudget(seconds)) << seconds;
  for (double rate : {-60.0, 0.5, 1001.0, HUGE_VAL, double(NAN)})
    EXPECT_FALSE(budget.setFrameRate(rate)) << rate;
  EXPECT_EQ(budget.budget(), TeFrameBudget::kDefault);
  EXPECT_EQ(budget.frameRate(), 0);
  ASSERT_TRUE(budget.setBudget(0.002));
  budget.frameDrawn(1.0, 0.5);
  EXPECT_EQ(budget.budget(), 0.002);
}

TEST(TeFrameBudget, TakesWhatTheFrameLeavesAndStaysThere) {
  Program program;
  const double wanted = 0.9 * kFrame - 0.003 - 0.002;
  EXPECT_NEAR(program.run(300), std::min(wanted, kFrame / 2), 1e-4);
  for (int i = 0; i < 300; ++i)
    EXPECT_NEAR(program.runFrame(), std::min(wanted, kFrame / 2), 1e-4);
  EXPECT_EQ(program.late, 0);
  program.draw = 0.008;
  const double less = 0.9 * kFrame - 0.008 - 0.002;
  program.run(300);
  EXPECT_LE(program.late, 2);
  program.late = 0;
  for (int i = 0; i < 300; ++i)
    EXPECT_NEAR(program.runFrame(), less, 1e-4);
  EXPECT_EQ(program.late, 0);
}

TEST(TeFrameBudget, FallsWithinFramesAndRisesInTens) {
  Program program;
  const double before = program.run(300);
  program.draw = 0.012;
  const double during = program.run(6);
  EXPECT_LT(during, 0.0015);
  program.draw = 0.003;
  int frames = 0;
  for (double last = during; program.budget.budget() < 0.9 * before; ++frames) {
    const double now = program.runFrame();
    ASSERT_GE(now, last);
    ASSERT_LT(now - last, 0.0005);
    last = now;
    ASSERT_LT(frames, 300);
  }
  EXPECT_GT(frames, 20);
}

TEST(TeFrameBudget, StaysWithinItsLimitsWhateverIsMeasured) {
  Program program;
  program.draw = 0.1;
  EXPECT_EQ(program.run(20), TeFrameBudget::kLeast);
  program.draw = program.rest = 0;
  EXPECT_NEAR(program.run(1000), kFrame / 2, 1e-9);
  for (double value : {-1.0, HUGE_VAL, double(NAN)}) {
    program.budget.frameDrawn(value, 0.001);
    program.budget.frameDrawn(kFrame, value);
    program.budget.tickDone(value, value);
  }
  EXPECT_NEAR(program.budget.budget(), kFrame / 2, 1e-9);
}

TEST(TeFrameBudget, OneSlowFrameChangesLittle) {
  Program program;
  const double before = program.run(300);
  program.budget.frameDrawn(0.5, 0.003);
  EXPECT_GT(program.budget.budget(), 0.9 * before);
  EXPECT_GT(program.run(1), 0.9 * before);
}

TEST(TeFrameBudget, NoiseMakesNoWaves) {
  Program program;
  program.draw = 0.006;
  program.noise = 0.3;
  program.run(300);
  double low = 1, high = 0;
  for (int i = 0; i < 2000; ++i) {
    const double now = program.runFrame();
    low = std::min(low, now);
    high = std::max(high, now);
  }
  EXPECT_LT(high - low, 0.0015);
  EXPECT_EQ(program.late, 0);
}

TEST(TeFrameBudget, FindsWhatIsFreeBehindADisplayThatWaits) {
  Program program;
  program.display = true;
  program.draw = 0.006;
  program.rest = 0.004; // unseen but for late frames
  program.run(2000);
  program.late = 0;
  program.run(10000);
  EXPECT_LT(program.late, 200);
  program.rest = 0.0005;
  EXPECT_GT(program.run(6000), 0.006);
}

TEST(TeFrameBudget, KeepsTheLongestRecentUnitInReserve) {
  TeFrameBudget budget;
  ASSERT_TRUE(budget.setBudget(0.004));
  for (int i = 0; i < 200; ++i)
    budget.tickDone(0.003, 0.0001);
  EXPECT_NEAR(budget.allowance(), 0.0039, 1e-6);
  budget.tickDone(0.004, 0.001);
  EXPECT_NEAR(budget.allowance(), 0.003, 1e-9);
  for (int i = 0; i < 200; ++i)
    budget.tickDone(0.003, 0.0001);
  EXPECT_NEAR(budget.allowance(), 0.0039, 1e-6);
  budget.tickDone(0.1, 0.1);
  EXPECT_NEAR(budget.allowance(), 0.0005, 1e-9);
}
