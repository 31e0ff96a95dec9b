#include "engine/terrain/TeLookAhead.h"
#include "engine/terrain/TePatchBlock.h"

#include <gtest/gtest.h>

#include <set>

namespace {

const TeLattice kLattice = *TeLattice::create(65, 1.0); // patches of 32 m

/// Patches that the blocks foreseen add to the object's own.
std::size_t patchesAhead(glm::dvec2 position, glm::dvec2 velocity, int radius) {
  const TePatchBlock own{*tePatchAt(kLattice, position), radius};
  std::set<TePatchKey> keys;
  for (const TePatchKey& centre : TeLookAhead::centres(kLattice, position, velocity))
    TePatchBlock{centre, radius}.forEach([&](const TePatchKey& key) {
      if (!own.contains(key))
        keys.insert(key);
    });
  return keys.size();
}

TEST(TeLookAhead, InTheMiddleNothingIsForeseen) {
  EXPECT_TRUE(TeLookAhead::centres(kLattice, {0, 0}, {0, 0}).empty());
  EXPECT_TRUE(TeLookAhead::centres(kLattice, {7.9, -7.9}, {0, 0}).empty());
}

TEST(TeLookAhead, NearAnEdgeThreePatchesAndNearACornerFive) {
  EXPECT_EQ(patchesAhead({14, 0}, {0, 0}, 1), 3u);
  EXPECT_EQ(patchesAhead({0, -14}, {0, 0}, 1), 3u);
  EXPECT_EQ(patchesAhead({14, 14}, {0, 0}, 1), 5u);
  EXPECT_EQ(patchesAhead({-14, 14}, {0, 0}, 1), 5u);
}

TEST(TeLookAhead, FartherAheadWithSpeed) {
  const std::vector<TePatchKey> slow = TeLookAhead::centres(kLattice, {0, 0}, {0, 20});
  const std::vector<TePatchKey> fast = TeLookAhead::centres(kLattice, {0, 0}, {0, 600});
  EXPECT_EQ(slow, (std::vector<TePatchKey>{{0, 1, 0}}));
  ASSERT_EQ(fast.size(), 28u); // 1.5 s · 600 m/s = 900 m
  for (std::size_t i = 0; i < fast.size(); ++i)
    EXPECT_EQ(fast[i], (TePatchKey{0, std::int64_t(i) + 1, 0})) << "in the order in which they are reached";
}

TEST(TeLookAhead, HoweverFastTheNumberIsBounded) {
  EXPECT_LE(TeLookAhead::centres(kLattice, {0, 0}, {1e9, 1e9}).size(), std::size_t(TeLookAhead::kMaxCentres));
  EXPECT_LE(TeLookAhead::centres(kLattice, {0, 0}, {1e300, 0}).size(), std::size_t(TeLookAhead::kMaxCentres));
}

TEST(TeLookAhead, TheRimOfTheWorldHasNoPatchesBeyond) {
  const double rim = 0x1p47 * 32 - 16 - 32; // the easternmost patch begins there
  for (const TePatchKey& key : TeLookAhead::centres(kLattice, {rim + 24, 0}, {1000, 0}))
    EXPECT_TRUE(key.valid());
  EXPECT_TRUE(TeLookAhead::centres(kLattice, {1e300, 0}, {1, 0}).empty());
}

} // namespace
