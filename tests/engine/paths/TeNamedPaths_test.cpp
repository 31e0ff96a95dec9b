#include "engine/paths/TeNamedPaths.h"

#include "engine/paths/TePathTraveller.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace {

TePathTraveller travellerOf(const std::string& name, const glm::dvec3& start = {0, 0, 60}) {
  TeResult<TePath> path = teNamedPath(name, start, true);
  EXPECT_TRUE(path) << name;
  return TePathTraveller(std::move(*path), 60);
}

TEST(TeNamedPaths, AllBeginNorthwardsAtTheStartAndNeverEnd) {
  for (const std::string& name : tePathNames()) {
    TePathTraveller traveller = travellerOf(name, {-60, 7, 55});
    EXPECT_EQ(traveller.place(), glm::dvec3(-60, 7, 55)) << name;
    EXPECT_TRUE(traveller.aboveGround());
    EXPECT_GT(traveller.direction().y, 0.99) << name;
    traveller.advance(1e5);
    EXPECT_FALSE(traveller.ended()) << name;
    EXPECT_EQ(traveller.place().z, 55) << name;
  }
}

TEST(TeNamedPaths, TheLineLeadsStraightNorth) {
  TePathTraveller traveller = travellerOf("line");
  traveller.advance(1000);
  EXPECT_EQ(traveller.place().x, 0);
  EXPECT_NEAR(traveller.place().y, 60000, 1e-6);
}

TEST(TeNamedPaths, TheCircleKeepsItsRadius) {
  TePathTraveller traveller = travellerOf("circle");
  const glm::dvec3 middle(-kTeCircleRadius, 0, 60);
  for (int i = 0; i < 1000; ++i) {
    traveller.advance(0.1);
    EXPECT_NEAR(glm::distance(traveller.place(), middle), kTeCircleRadius, 0.1);
  }
}

TEST(TeNamedPaths, TheZigzagTurnsSoftlyBothWays) {
  TePathTraveller traveller = travellerOf("zigzag");
  double east = 0, west = 0;
  glm::dvec3 before = traveller.direction();
  for (int i = 0; i < 5000; ++i) {
    traveller.advance(0.02);
    EXPECT_GT(glm::dot(traveller.direction(), before), 0.99);
    before = traveller.direction();
    east = std::max(east, before.x);
    west = std::min(west, before.x);
  }
  EXPECT_NEAR(east, std::sqrt(0.5), 0.01);
  EXPECT_NEAR(west, -std::sqrt(0.5), 0.01);
  EXPECT_GT(traveller.place().y, 3000);
}

TEST(TeNamedPaths, TheTeleportPathLeadsBeyondTwoToThe31Patches) {
  TePathTraveller traveller = travellerOf("teleport");
  double farthest = 0;
  for (int i = 0; i < 80; ++i) {
    traveller.advance(0.1);
    farthest = std::max(farthest, std::abs(traveller.place().x));
  }
  EXPECT_GT(farthest / 32, std::pow(2, 31));
  EXPECT_EQ(traveller.jumps(), 8);
  EXPECT_NEAR(glm::distance(traveller.place(), {0, 0, 60}), 0, 100); // back again
}

TEST(TeNamedPaths, UnknownNamesAndPlacesTooFarOutAreRefused) {
  const TeResult<TePath> unknown = teNamedPath("cirkle", {0, 0, 0}, false);
  ASSERT_FALSE(unknown);
  EXPECT_NE(unknown.error().message.find("circle"), std::string::npos);
  EXPECT_FALSE(teNamedPath("teleport", {4e15, 0, 0}, false));
}

} // namespace
