#include "patchdb/TePatchDatabase.h"

#include "patchdb/TeTestWorlds.h"

#include <gtest/gtest.h>

#include <cstring>

TEST(TePatchDatabase, RefusesAWorldWithoutSourcesOrWithAbsurdSpacing) {
  EXPECT_FALSE(TePatchDatabase::create({*TeLattice::create(65, 1.0), 0, nullptr}));
  const auto sources = std::make_shared<TeSingleSource>(std::make_shared<TeHashSource>());
  for (double spacing : {1e-300, 1e-7, 1e7, 1e300})
    EXPECT_FALSE(TePatchDatabase::create({*TeLattice::create(65, spacing), 0, sources})) << spacing;
}

TEST(TePatchDatabase, BuildsPatchesThatShareTheirMapsAndBorders) {
  auto database = teTestDatabase(std::make_shared<TeHashSource>(), 17);
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x)
      ASSERT_TRUE(database->build({x, y, 0}));
  EXPECT_EQ(database->maps().residentMaps(), 16u);
  const TePatchData& middle = *database->find({0, 0, 0});
  const TePatchData& east = *middle.neighbour(TeDirection::East);
  EXPECT_EQ(middle.map(1).get(), east.map(0).get());
  EXPECT_EQ(middle.map(3).get(), middle.neighbour(TeDirection::NorthEast)->map(0).get());
  for (int y = 0; y <= 8; ++y) {
    const float a = middle.heights().at(8, y);
    const float b = east.heights().at(0, y);
    EXPECT_EQ(std::memcmp(&a, &b, sizeof a), 0) << y;
  }
}

TEST(TePatchDatabase, MapsAreFreedWithTheLastPatchThatHoldsThem) {
  auto database = teTestDatabase(std::make_shared<TeHashSource>(), 17);
  ASSERT_TRUE(database->build({0, 0, 0}));
  ASSERT_TRUE(database->build({1, 0, 0}));
  EXPECT_EQ(database->maps().residentMaps(), 6u);
  EXPECT_TRUE(database->remove({0, 0, 0}));
  EXPECT_EQ(database->maps().residentMaps(), 4u);
  database->find({1, 0, 0})->dropMaps();
  EXPECT_EQ(database->maps().residentMaps(), 0u);
  EXPECT_EQ(database->maps().residentBytes(), 0u);
  EXPECT_FALSE(database->remove({0, 0, 0}));
}

TEST(TePatchDatabase, ADroppedMapComesBackTheSameAfterTheSourcesHaveChanged) {
  auto database = teTestDatabase(std::make_shared<TeHashSource>(1), 17);
  const TeHeightMap before = (*database->build({0, 0, 0}))->heights();
  database->remove({0, 0, 0});
  ASSERT_TRUE(database->setSources(std::make_shared<TeSingleSource>(std::make_shared<TeHashSource>(2))));
  EXPECT_TRUE((*database->build({0, 0, 0}))->heights() == before);
  // The neighbour takes the new source for its two new maps and still fits on the common border.
  const TePatchData& east = **database->build({1, 0, 0});
  EXPECT_EQ(east.map(0)->source->fingerprint(), TeHashSource(1).fingerprint());
  EXPECT_EQ(east.map(1)->source->fingerprint(), TeHashSource(2).fingerprint());
  for (int y = 0; y <= 8; ++y)
    EXPECT_EQ(east.heights().at(0, y), before.at(8, y));
}

TEST(TePatchDatabase, OneSeamObjectServesAllPatchesThatMeet) {
  auto database = teTestDatabase(std::make_shared<TeHashSource>(), 17);
  for (int y = 0; y <= 1; ++y)
    for (int x = 0; x <= 1; ++x)
      ASSERT_TRUE(database->build({x, y, 0}));
  TePatchData& southWest = *database->find({0, 0, 0});
  TePatchData& southEast = *database->find({1, 0, 0});
  TePatchData& northWest = *database->find({0, 1, 0});
  TePatchData& northEast = *database->find({1, 1, 0});
  const TePatchMeshPtr seam = *database->seam(southEast, TeDirection::West);
  EXPECT_EQ(*database->seam(southWest, TeDirection::East), seam);
  EXPECT_EQ(seam->key, southWest.key());
  EXPECT_EQ(seam->direction, TeDirection::East);
  const TePatchMeshPtr corner = *database->seam(northWest, TeDirection::SouthEast);
  EXPECT_EQ(southWest.seam(TeDirection::NorthEast), corner);
  EXPECT_EQ(southEast.seam(TeDirection::NorthWest), corner);
  EXPECT_EQ(northEast.seam(TeDirection::SouthWest), corner);
  EXPECT_EQ(corner->part, TeSurfacePart::Corner);
  EXPECT_EQ(corner->key, southWest.key());
  EXPECT_EQ(northWest.seam(TeDirection::South), nullptr);
  // A patch that goes takes its seams along.
  database->remove({1, 0, 0});
  EXPECT_EQ(southWest.seam(TeDirection::East), nullptr);
  EXPECT_EQ(northWest.seam(TeDirection::SouthEast), nullptr);
  EXPECT_EQ(southWest.neighbour(TeDirection::East), nullptr);
}

TEST(TePatchDatabase, ASeamWithoutItsNeighbourIsAnErrorThatNamesIt) {
  auto database = teTestDatabase(std::make_shared<TeHashSource>(), 17);
  ASSERT_TRUE(database->build({3, -4, 0}));
  const auto seam = database->seamMesh(*database->find({3, -4, 0}), TeDirection::East);
  ASSERT_FALSE(seam);
  EXPECT_NE(seam.error().message.find("(4, -4)"), std::string::npos) << seam.error().message;
}

TEST(TePatchDatabase, SourcesThatFailOrLieAreErrors) {
  class Failing final : public TePointSource {
  public:
    std::string name() const override { return "failing"; }
    std::uint64_t fingerprint() const override { return 1; }
    TeStatus evaluate(const TeMapRequest&, const TeMapSample*, std::size_t, float*) const override {
      return TeError{"no luck"};
    }
  };
  auto database = teTestDatabase(std::make_shared<Failing>(), 17);
  const auto patch = database->build({5, 6, 0});
  ASSERT_FALSE(patch);
  EXPECT_EQ(patch.error().message, "patch (5, 6) level 0: source map (5, 6): no luck");
  EXPECT_EQ(database->find({5, 6, 0}), nullptr);
  EXPECT_FALSE(database->build({0, 0, 1}));
  EXPECT_FALSE(database->build({TeLattice::kMaxKey, 0, 0}));
}
