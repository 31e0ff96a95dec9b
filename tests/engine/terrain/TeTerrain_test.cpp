#include "engine/terrain/TeTerrain.h"

#include "engine/objects/TeObject.h"
#include "nodes/TeNodes.h"
#include "patchdb/TeTestWorlds.h"

#include <gtest/gtest.h>

#include <set>

namespace {

/// A terrain without engine, camera and objects.
class TeTerrainTest : public testing::Test {
protected:
  TeTerrainTest() : m_database(teTestDatabase(std::make_shared<TeHashSource>(), 17)), m_maps(*m_database) {
    TeNodes::init();
    m_scene = std::make_unique<TeTerrainScene>(m_database->lattice(), glm::dvec3(0));
    m_terrain = std::make_unique<TeTerrain>(*m_database, *m_scene, m_queue, m_maps,
                                            [this](const TePatchKey& key) { return m_held.count(key) > 0; });
    m_terrain->setRadius(1);
  }
  ~TeTerrainTest() override { m_queue.clear(); }

  double side() const { return m_database->lattice().patchSide(); }
  void follow(double x, double y, glm::dvec3 velocity = {0, 0, 0}) {
    m_view.position = {x, y, 0};
    m_view.velocity = velocity;
    m_terrain->follow(m_view);
  }
  std::int64_t work(std::int64_t units) {
    TeAllowance allowance = TeAllowance::units(units);
    m_terrain->work(allowance);
    return allowance.unitsSpent();
  }
  void finish() {
    for (int i = 0; i < 10000 && !m_terrain->idle(); ++i)
      work(100);
    ASSERT_TRUE(m_terrain->idle());
  }
  TeStatistics count() {
    TeStatistics statistics;
    m_terrain->count(statistics);
    return statistics;
  }

  std::unique_ptr<TePatchDatabase> m_database;
  std::unique_ptr<TeTerrainScene> m_scene;
  TeMapMaker m_maps;
  TeJobQueue m_queue;
  std::set<TePatchKey> m_held;
  std::unique_ptr<TeTerrain> m_terrain;
  TeTerrainView m_view;
};

TEST_F(TeTerrainTest, ASliceSpendsLittleMoreThanItsUnits) {
  m_terrain->setRadius(6);
  follow(0, 0);
  for (int i = 0; i < 2000 && !m_terrain->idle(); ++i)
    EXPECT_LE(work(5), 5 + 2) << "one unit, and the upload of one piece";
  EXPECT_EQ(count().patches.drawn, 169);
}

TEST_F(TeTerrainTest, ThePatchBelowComesBeforeAllOthers) {
  m_terrain->setRadius(8);
  follow(1000 * side(), 0);
  std::int64_t units = 0;
  while (!m_terrain->hasGround({1000 * side(), 0, 0}))
    units += work(1);
  EXPECT_EQ(count().patches.resident, 1);
  EXPECT_EQ(units, 4 * 17 + 1) << "four maps of 17 rows, and their blend";
}

TEST_F(TeTerrainTest, WhatIsInViewComesBeforeWhatIsBehind) {
  m_terrain->setRadius(5);
  m_view.frustum =
      TeViewFrustum({0, 0, 0}, glm::angleAxis(std::acos(0.0), glm::dvec3(1, 0, 0)), 0.8, 1.3); // to the north
  follow(0, 0);
  while (count().patches.missingInView > 0)
    work(4);
  // Hardly anything that is out of view was made; that is, the south half is empty but for what meets the
  // view.
  int south = 0;
  for (int x = -5; x <= 5; ++x)
    for (int y = -5; y <= -2; ++y)
      south += m_database->find({x, y, 0}) ? 1 : 0;
  EXPECT_LE(south, 2);
  finish();
  EXPECT_EQ(count().patches.drawn, 121);
}

TEST_F(TeTerrainTest, PatchesThatAProgramHoldsAreNotDropped) {
  m_held.insert({0, 0, 0});
  follow(0, 0);
  finish();
  follow(1000 * side(), 0);
  finish();
  EXPECT_NE(m_database->find({0, 0, 0}), nullptr);
  EXPECT_EQ(m_database->find({1, 1, 0}), nullptr);
  EXPECT_EQ(count().patches.dropped, 9 - 1);
}

TEST_F(TeTerrainTest, APatchThatAProgramHasBuiltIsUsed) {
  ASSERT_TRUE(m_database->build({1, 0, 0}));
  follow(0, 0);
  finish();
  EXPECT_EQ(count().patches.drawn, 9);
}

TEST_F(TeTerrainTest, MemoryIsCountedBackToNothingWhenAllIsDropped) {
  follow(0, 0);
  finish();
  const TeStatistics before = count();
  EXPECT_GT(before.memory.heights, 0u);
  EXPECT_GT(before.memory.meshes, 0u);
  for (const double x : {1e5, -1e6, 0.0}) {
    follow(x, 0);
    finish();
  }
  const TeStatistics after = count();
  EXPECT_EQ(after.memory.heights, before.memory.heights);
  EXPECT_EQ(after.memory.meshes, before.memory.meshes);
  EXPECT_EQ(after.memory.maps, before.memory.maps);
  EXPECT_EQ(after.patches.madeAgain, 9);
}

TEST_F(TeTerrainTest, EqualTerrainHasEqualHashes) {
  follow(0, 0);
  finish();
  const std::uint64_t here = m_terrain->hash();
  follow(5 * side(), 0);
  finish();
  EXPECT_NE(m_terrain->hash(), here);
  follow(0, 0);
  finish();
  EXPECT_EQ(m_terrain->hash(), here);
}

} // namespace
