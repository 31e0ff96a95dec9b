#include "engine/terrain/TeTerrainPlan.h"

#include "engine/objects/TeObject.h"

#include <gtest/gtest.h>

#include <set>

namespace {

const TeLattice kLattice = *TeLattice::create(65, 1.0); // patches of 32 m

TeTerrainView viewAt(double x, double y, glm::dvec3 velocity = {0, 0, 0}) {
  TeTerrainView view;
  view.position = {x, y, 0};
  view.velocity = velocity;
  return view;
}

TEST(TePatchBlock, WhatLiesBeyondAnotherBlockIsVisitedOnce) {
  for (const int radius : {1, 2, 5})
    for (std::int64_t dx = -12; dx <= 12; ++dx)
      for (std::int64_t dy = -12; dy <= 12; ++dy) {
        const TePatchBlock here{{3, -4, 0}, radius};
        const TePatchBlock there{{3 + dx, -4 + dy, 0}, radius};
        std::set<TePatchKey> expected, visited;
        there.forEach([&](const TePatchKey& key) {
          if (!here.contains(key))
            expected.insert(key);
        });
        there.forEachBeyond(here, [&](const TePatchKey& key) { EXPECT_TRUE(visited.insert(key).second); });
        ASSERT_EQ(visited, expected) << radius << " " << dx << " " << dy;
      }
}

TEST(TeTerrainPlan, TheBlockChangesOnCrossingAnEdgeOnly) {
  TeTerrainPlan plan;
  plan.setRadius(2);
  EXPECT_TRUE(plan.update(kLattice, viewAt(0, 0)));
  EXPECT_TRUE(plan.blockChanged());
  EXPECT_FALSE(plan.update(kLattice, viewAt(5, 0)));
  EXPECT_TRUE(plan.update(kLattice, viewAt(14, 0))) << "an edge is near";
  EXPECT_FALSE(plan.blockChanged());
  EXPECT_TRUE(plan.update(kLattice, viewAt(17, 0)));
  EXPECT_TRUE(plan.blockChanged());
  EXPECT_FALSE(plan.jumped());
  EXPECT_EQ(plan.block().centre, (TePatchKey{1, 0, 0}));
}

TEST(TeTerrainPlan, AJumpLeavesTheWholeBlockBehind) {
  TeTerrainPlan plan;
  plan.setRadius(1);
  plan.update(kLattice, viewAt(0, 0));
  plan.update(kLattice, viewAt(64, 0));
  EXPECT_FALSE(plan.jumped()) << "one column is shared";
  plan.update(kLattice, viewAt(64 + 96, 0));
  EXPECT_TRUE(plan.jumped());
}

TEST(TeTerrainPlan, WhatIsForeseenIsDrawableAndInNoBlockYet) {
  TeTerrainPlan plan;
  plan.setRadius(1);
  plan.update(kLattice, viewAt(0, 0, {150, 60, 0}));
  std::set<TePatchKey> ahead;
  plan.forEachAhead([&](const TePatchKey& key) {
    EXPECT_FALSE(plan.inBlock(key));
    EXPECT_TRUE(plan.drawable(key));
    ahead.insert(key);
  });
  // All that is drawable is in the block or was visited.
  for (std::int64_t y = -20; y <= 20; ++y)
    for (std::int64_t x = -20; x <= 20; ++x) {
      const TePatchKey key{x, y, 0};
      EXPECT_EQ(plan.drawable(key), plan.inBlock(key) || ahead.count(key) > 0) << key.text();
    }
  EXPECT_GT(ahead.size(), 10u);
}

TEST(TeTerrainPlan, ObjectsWantThePatchesBelowThemWithoutDrawing) {
  class Thing : public TeObject {
  public:
    Thing() : TeObject("thing") {}
  } thing;
  ASSERT_TRUE(thing.setPosition({3200, 0, 0}));
  TeTerrainPlan plan;
  plan.update(kLattice, viewAt(0, 0));
  plan.place(thing, kLattice);
  EXPECT_TRUE(plan.outdated());
  EXPECT_TRUE(plan.update(kLattice, viewAt(0, 0)));
  EXPECT_TRUE(plan.wanted({100, 0, 0}));
  EXPECT_FALSE(plan.drawable({100, 0, 0}));
  plan.forget(thing);
  EXPECT_FALSE(plan.wanted({100, 0, 0}));
}

TEST(TeTerrainPlan, OutsideTheWorldTheLastBlockStays) {
  TeTerrainPlan plan;
  plan.setRadius(1);
  plan.update(kLattice, viewAt(320, 0));
  EXPECT_FALSE(plan.update(kLattice, viewAt(1e300, 0)));
  EXPECT_EQ(plan.block().centre, (TePatchKey{10, 0, 0}));
}

TEST(TeTerrainPlan, AnotherRadiusHoldsFromTheNextUpdateInTheWorld) {
  TeTerrainPlan plan;
  plan.setRadius(1);
  plan.update(kLattice, viewAt(0, 0));
  plan.setRadius(3);
  EXPECT_EQ(plan.block().radius, 1);
  EXPECT_FALSE(plan.update(kLattice, viewAt(1e300, 0)));
  EXPECT_EQ(plan.block().radius, 1);
  EXPECT_TRUE(plan.update(kLattice, viewAt(0, 0)));
  EXPECT_TRUE(plan.blockChanged());
  EXPECT_FALSE(plan.jumped());
  EXPECT_EQ(plan.block().radius, 3);
  plan.setRadius(2);
  plan.update(kLattice, viewAt(3200, 0));
  EXPECT_TRUE(plan.jumped()) << "with another radius, too";
}

} // namespace
