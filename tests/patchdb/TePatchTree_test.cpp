#include "patchdb/TePatchTree.h"

#include <gtest/gtest.h>

TEST(TePatchTree, AnswersByStrategy) {
  TePatchTree tree;
  const TePatchKey key{-5, 3, 0};
  EXPECT_EQ(*tree.lookup(key, TeLookup::Null), nullptr);
  EXPECT_EQ(*tree.lookup(key, TeLookup::NearestCoarser), nullptr);
  EXPECT_EQ(tree.size(), 0u);
  TePatchData* coarse = *tree.lookup(*key.ancestor(4), TeLookup::Create);
  TePatchData* coarser = *tree.lookup(*key.ancestor(9), TeLookup::Create);
  EXPECT_EQ(*tree.lookup(key, TeLookup::NearestCoarser), coarse);
  EXPECT_EQ(*tree.lookup(*key.ancestor(4), TeLookup::NearestCoarser), coarse);
  EXPECT_EQ(*tree.lookup(*key.ancestor(5), TeLookup::NearestCoarser), coarser);
  EXPECT_EQ(*tree.lookup(*key.ancestor(10), TeLookup::NearestCoarser), nullptr);
  EXPECT_EQ(*tree.lookup({1000, 3, 0}, TeLookup::NearestCoarser), nullptr);
  TePatchData* made = *tree.lookup(key, TeLookup::Create);
  EXPECT_EQ(made->key(), key);
  EXPECT_EQ(*tree.lookup(key, TeLookup::Create), made);
  EXPECT_EQ(*tree.lookup(key, TeLookup::NearestCoarser), made);
  EXPECT_EQ(*tree.lookup(key, TeLookup::Null), made);
  EXPECT_EQ(tree.size(), 3u);
}

TEST(TePatchTree, NearestWithHeightsPassesOverEmptyRecords) {
  TePatchTree tree;
  const TePatchKey key{2, 2, 0};
  tree.lookup(key, TeLookup::Create).value();
  TePatchData* coarse = *tree.lookup(*key.ancestor(3), TeLookup::Create);
  EXPECT_EQ(tree.nearestWithHeights(key), nullptr);
  coarse->setHeights(*TeHeightMap::create(5, 5), 2.5f);
  EXPECT_EQ(tree.nearestWithHeights(key), coarse);
}

TEST(TePatchTree, RefusesInvalidKeys) {
  TePatchTree tree;
  for (TePatchKey key : {TePatchKey{0, 0, -1}, TePatchKey{0, 0, 48}, TePatchKey{TeLattice::kMaxKey, 0, 0}})
    for (TeLookup strategy : {TeLookup::Create, TeLookup::NearestCoarser, TeLookup::Null})
      EXPECT_FALSE(tree.lookup(key, strategy));
  EXPECT_FALSE(tree.remove({0, 0, 99}));
}

TEST(TePatchTree, NeighboursPointAtEachOtherHoweverRecordsComeAndGo) {
  TePatchTree tree;
  std::uint64_t state = 1;
  for (int i = 0; i < 5000; ++i) {
    state = state * 6364136223846793005ull + 1442695040888963407ull;
    const TePatchKey key{std::int64_t(state >> 33) % 4, std::int64_t(state >> 40) % 4, int(state >> 62) % 2};
    if (!tree.remove(key))
      tree.lookup(key, TeLookup::Create).value();
    for (int level = 0; level < 2; ++level)
      for (std::int64_t y = 0; y < 4; ++y)
        for (std::int64_t x = 0; x < 4; ++x)
          if (TePatchData* patch = tree.find({x, y, level}))
            for (TeDirection direction : kTeDirections) {
              const glm::ivec2 step = teStep(direction);
              ASSERT_EQ(patch->neighbour(direction), tree.find({x + step.x, y + step.y, level}));
            }
  }
}
