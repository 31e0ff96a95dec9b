#include "engine/TeEndlessWorld.h"
#include "engine/TeEngine.h"
#include "engine/budget/TeFrameBudget.h"
#include "engine/quality/TeQuality.h"
#include "generators/base/TeRandom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

constexpr double kRate = 60;
constexpr double kFrame = 1 / kRate;

/// Both controllers in the loop of a program: drawing costs load / px, a tick all that it may, if there is
/// terrain to be made.
struct Program {
  TeFrameBudget budget;
  TeQuality quality;
  double load = TeEngine::kDrawingShare * kFrame;
  double rest = 0.0005;
  double noise = 0;
  bool makesTerrain = true;
  TeRandom random{5, 1, {}};
  std::vector<double> errors;
  std::vector<double> budgets;
  std::vector<double> frames;

  Program() {
    EXPECT_TRUE(budget.setFrameRate(kRate));
    EXPECT_TRUE(quality.setRange(0.1, 100));
    EXPECT_TRUE(quality.setGoal(TeEngine::kDrawingShare / kRate));
  }
  void run(double seconds) {
    for (double time = 0; time < seconds; time += frames.back()) {
      const double tick = makesTerrain ? budget.budget() : 0.0002;
      const double draw = load / quality.pixelError() * (1 + noise * random.uniform(-1.0, 1.0));
      budget.tickDone(tick, 0.0002);
      const double frame = std::max(kFrame, tick + draw + rest);
      budget.frameDrawn(frame, draw);
      quality.frameDrawn(draw);
      errors.push_back(quality.pixelError());
      budgets.push_back(budget.budget());
      frames.push_back(tick + draw + rest);
    }
  }
};

int turns(const std::vector<double>& values, std::size_t from, double least) {
  int turns = 0;
  double extreme = values[from];
  int direction = 0;
  for (std::size_t i = from; i < values.size(); ++i) {
    const double way = values[i] - extreme;
    if (direction == 0 || way * direction > 0) {
      if (std::fabs(way) > least)
        direction = way > 0 ? 1 : -1;
      if (direction == 0 || way * direction > 0)
        extreme = direction == 0 ? extreme : values[i];
    } else if (std::fabs(way) > least) {
      ++turns;
      direction = -direction;
      extreme = values[i];
    }
  }
  return turns;
}

} // namespace

// A dearer scene: the budget gives way at once, the error then gives its part back, and both come to rest.
TEST(TeQualityAndBudget, TheBudgetGivesWayFirstAndNeitherSwings) {
  for (const double noise : {0.0, 0.1}) {
    Program program;
    program.noise = noise;
    program.run(4);
    const double budgetBefore = program.budgets.back();
    const double errorBefore = program.errors.back();
    EXPECT_GT(budgetBefore, 0.08 * kFrame) << "a part of the frame is left to generation";
    const std::size_t step = program.budgets.size();
    program.load *= 1.6;
    program.run(1);
    EXPECT_LT(program.budgets[step], 0.5 * budgetBefore) << "in the first frame";
    EXPECT_EQ(program.errors[step], errorBefore) << "one frame says nothing yet";
    EXPECT_GT(program.errors.back(), errorBefore);
    program.run(3);
    EXPECT_NEAR(program.budgets.back(), budgetBefore, (noise > 0 ? 0.5 : 0.25) * budgetBefore);
    const std::size_t settled = program.errors.size();
    program.run(10);
    EXPECT_LE(turns(program.errors, settled, 0.02 * program.errors.back()), 1);
    if (noise == 0) {
      EXPECT_LE(turns(program.budgets, settled, 0.05 * budgetBefore), 0);
    }
    const double late =
        double(std::count_if(program.frames.begin() + std::ptrdiff_t(settled), program.frames.end(),
                             [](double frame) { return frame > kFrame; }));
    EXPECT_LE(late, 0.02 * double(program.frames.size() - settled));
  }
}

// What generation takes says nothing about drawing: the error does not follow it.
TEST(TeQualityAndBudget, WorkForTerrainDoesNotChangeTheError) {
  Program program;
  program.makesTerrain = false;
  program.run(3);
  const double error = program.errors.back();
  for (int i = 0; i < 6; ++i) {
    program.makesTerrain = i % 2 == 0;
    program.run(1);
    EXPECT_EQ(program.errors.back(), error);
  }
}

TEST(TeQualityAndBudget, AnEngineChecksItsSettings) {
  TeEndlessWorld world;
  TeEngine& engine = world.engine;
  for (const double pixels : {-1.0, 2000.0, HUGE_VAL, double(NAN)})
    EXPECT_FALSE(engine.setPixelError(pixels)) << pixels;
  for (const double rate : {-60.0, 0.5, 2000.0, HUGE_VAL, double(NAN)})
    EXPECT_FALSE(engine.setQualityGoal(rate)) << rate;
  EXPECT_FALSE(engine.setQualityRange(0, 1));
  EXPECT_FALSE(engine.setQualityRange(4, 2));
  ASSERT_TRUE(engine.setPixelError(2));
  ASSERT_TRUE(engine.initialize());
  EXPECT_EQ(world.statistics().pixelError, 2);
  EXPECT_EQ(world.statistics().frameGoalSeconds, 0);
  ASSERT_TRUE(engine.setPixelError(3));
  EXPECT_EQ(world.statistics().pixelError, 3) << "at any time";
}

TEST(TeQualityAndBudget, AnEngineHoldsItsGoal) {
  TeEndlessWorld world;
  TeEngine& engine = world.engine;
  ASSERT_TRUE(engine.setQualityGoal(50));
  ASSERT_TRUE(engine.initialize());
  engine.finishJobs();
  EXPECT_NEAR(world.statistics().pixelError, 1, 1e-12);
  EXPECT_NEAR(world.statistics().frameGoalSeconds, 0.02, 1e-12);
  const auto run = [&](double load, int frames) {
    for (int i = 0; i < frames; ++i) {
      ASSERT_TRUE(engine.timeTick(0.02));
      engine.frameDrawn(0.02, 0.001, load / world.statistics().pixelError);
    }
  };
  run(0.045, 100);
  EXPECT_NEAR(0.045 / world.statistics().pixelError, TeEngine::kDrawingShare * 0.02, 0.0016);
  EXPECT_TRUE(engine.isIdle()) << "at rest when it has arrived";
  // Without knowing when OpenGL was done, late frames tell it.
  for (int i = 0; i < 100; ++i) {
    ASSERT_TRUE(engine.timeTick(0.02));
    const double draw = 0.09 / world.statistics().pixelError;
    engine.frameDrawn(std::max(0.02, draw + 0.002), 0.001);
  }
  EXPECT_LE(0.09 / world.statistics().pixelError, 0.022);
  ASSERT_TRUE(engine.setQualityGoal(0));
  EXPECT_EQ(world.statistics().pixelError, 0) << "as was set before";
}
