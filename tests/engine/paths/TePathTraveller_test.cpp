#include "engine/paths/TePathTraveller.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace {

TePath pathOf(const char* text) {
  TeResult<TePath> path = TePath::parse(text, "text");
  EXPECT_TRUE(path) << (path ? "" : path.error().message);
  return std::move(*path);
}

TEST(TePathTraveller, MovesByArcLengthAtThePathsSpeeds) {
  TePathTraveller traveller(pathOf("0 0 10 5\n30 40 10 50\n30 1040 10\n"), 1);
  EXPECT_EQ(traveller.speed(), 5);
  traveller.advance(4);
  EXPECT_NEAR(glm::distance(traveller.place(), {12, 16, 10}), 0, 1e-12);
  EXPECT_NEAR(glm::distance(traveller.direction(), {0.6, 0.8, 0}), 0, 1e-12);
  traveller.advance(6 + 3); // 6 s to the corner, 3 s beyond it
  EXPECT_EQ(traveller.speed(), 50);
  EXPECT_NEAR(glm::distance(traveller.place(), {30, 190, 10}), 0, 1e-12);
  EXPECT_NEAR(traveller.distance(), 200, 1e-12);
}

TEST(TePathTraveller, StopsAtTheEnd) {
  TePathTraveller traveller(pathOf("0 0 10\n0 100 10\n"), 20);
  traveller.advance(1000);
  EXPECT_TRUE(traveller.ended());
  EXPECT_EQ(traveller.speed(), 0);
  EXPECT_EQ(traveller.place(), glm::dvec3(0, 100, 10));
  EXPECT_EQ(traveller.direction(), glm::dvec3(0, 1, 0));
  traveller.advance(1);
  EXPECT_EQ(traveller.place(), glm::dvec3(0, 100, 10));
}

TEST(TePathTraveller, TheSpeedCanBeSetForAllOfThePath) {
  TePathTraveller traveller(pathOf("0 0 10 5\n0 1000 10\n"), 100, true);
  traveller.advance(2);
  EXPECT_NEAR(traveller.place().y, 200, 1e-12);
}

TEST(TePathTraveller, JumpsTakeNoTime) {
  TePathTraveller traveller(pathOf("0 0 10\n0 100 10\njump 1e9 0 +60\n1e9 100 +60\n"), 10);
  traveller.advance(9.5);
  EXPECT_FALSE(traveller.aboveGround());
  traveller.advance(1);
  EXPECT_EQ(traveller.jumps(), 1);
  EXPECT_TRUE(traveller.aboveGround());
  EXPECT_NEAR(glm::distance(traveller.place(), {1e9, 5, 60}), 0, 1e-6);
  EXPECT_NEAR(traveller.distance(), 105, 1e-9);
}

TEST(TePathTraveller, StepsOfAnyLengthLeadToTheSamePlace) {
  const char* text = "0 0 10 30\n50 0 10 70\n50 50 10 20\n0 50 10\n0 0 10\nrepeat\n";
  TePathTraveller once(pathOf(text), 1), often(pathOf(text), 1);
  once.advance(100);
  for (int i = 0; i < 3000; ++i)
    often.advance(100.0 / 3000);
  EXPECT_NEAR(glm::distance(once.place(), often.place()), 0, 1e-6);
  EXPECT_NEAR(once.distance(), often.distance(), 1e-6);
}

TEST(TePathTraveller, EveryStepIsAsLongAsItsTime) {
  TePathTraveller traveller(pathOf("0 0 10\n0 1000 10\nrepeat\n"), 60);
  glm::dvec3 before = traveller.place();
  for (int i = 0; i < 2000; ++i) {
    traveller.advance(1 / 30.0);
    EXPECT_NEAR(glm::distance(traveller.place(), before), 2, 1e-9);
    before = traveller.place();
  }
}

TEST(TePathTraveller, RoundsAtAnySpeedCostNoTime) {
  TePathTraveller traveller(pathOf("0 0 10\n0.001 0 10\n0.001 0.001 10\n0 0 10\nrepeat\n"),
                            TePath::kMaxSpeed);
  for (int i = 0; i < 1000; ++i)
    traveller.advance(3600);
  EXPECT_LE(glm::distance(traveller.place(), {0, 0, 10}), 0.002);
}

} // namespace
