#include "patchdb/TePatchKey.h"

#include "generators/base/TeRandom.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

TEST(TePatchKey, ParentsAndChildrenAreFloorAligned) {
  EXPECT_EQ(*(TePatchKey{-1, -1, 0}).parent(), (TePatchKey{-1, -1, 1}));
  EXPECT_EQ(*(TePatchKey{-2, 1, 0}).parent(), (TePatchKey{-1, 0, 1}));
  EXPECT_EQ(*(TePatchKey{-3, 3, 0}).parent(), (TePatchKey{-2, 1, 1}));
  EXPECT_EQ(*(TePatchKey{-1, 0, 1}).child(0), (TePatchKey{-2, 0, 0}));
  EXPECT_EQ(*(TePatchKey{-1, 0, 1}).child(3), (TePatchKey{-1, 1, 0}));
  EXPECT_EQ((TePatchKey{-1, -2, 0}).childIndex(), 1);
  EXPECT_FALSE((TePatchKey{0, 0, 0}).child(0));
  EXPECT_FALSE((TePatchKey{0, 0, 1}).child(4));
  EXPECT_FALSE((TePatchKey{0, 0, 1}).child(-1));
}

TEST(TePatchKey, ContainsExactlyItsDescendants) {
  const TePatchKey patch{-3, 2, 2};
  int inside = 0;
  for (std::int64_t y = 0; y < 20; ++y)
    for (std::int64_t x = -20; x < 0; ++x)
      inside += patch.contains({x, y, 0}) ? 1 : 0;
  EXPECT_EQ(inside, 16);
  EXPECT_TRUE(patch.contains({-12, 8, 0}));
  EXPECT_TRUE(patch.contains({-9, 11, 0}));
  EXPECT_FALSE(patch.contains({-8, 8, 0}));
  EXPECT_TRUE(patch.contains(patch));
  EXPECT_FALSE(patch.contains(*patch.parent()));
}

TEST(TePatchKey, OrderIsByLevelThenRowThenColumn) {
  EXPECT_TRUE((TePatchKey{5, 5, 0}) < (TePatchKey{-5, -5, 1}));
  EXPECT_TRUE((TePatchKey{5, -1, 0}) < (TePatchKey{-5, 0, 0}));
  EXPECT_TRUE((TePatchKey{-1, 0, 0}) < (TePatchKey{0, 0, 0}));
  EXPECT_FALSE((TePatchKey{0, 0, 0}) < (TePatchKey{0, 0, 0}));
}

TEST(TePatchKey, PatchAtIsHalfOpenAndCentredOnTheOrigin) {
  const TeLattice lattice = *TeLattice::create(65, 2.0); // P = 64
  EXPECT_EQ(*tePatchAt(lattice, {0, 0}), (TePatchKey{0, 0, 0}));
  EXPECT_EQ(*tePatchAt(lattice, {32, -32}), (TePatchKey{1, 0, 0}));
  EXPECT_EQ(*tePatchAt(lattice, {std::nextafter(32.0, 0.0), std::nextafter(-32.0, -99.0)}),
            (TePatchKey{0, -1, 0}));
  EXPECT_EQ(*tePatchAt(lattice, {-33, 97}, 1), (TePatchKey{-1, 1, 1}));
  EXPECT_EQ(tePatchCentre(lattice, {3, -2, 0}), glm::dvec2(192, -128));
  EXPECT_EQ(tePatchOrigin(lattice, {-1, 1, 1}), glm::dvec2(-160, 96));
  EXPECT_EQ(tePatchCentre(lattice, {-1, 1, 1}), glm::dvec2(-96, 160));
}

TEST(TePatchKey, PatchAtRefusesPointsOutsideTheWorld) {
  const TeLattice lattice = *TeLattice::create(65, 1.0);
  for (double x : {double(NAN), double(INFINITY), -double(INFINITY), 1e300, 32 * 0x1p47, -33 * 0x1p47})
    for (glm::dvec2 point : {glm::dvec2(x, 0), glm::dvec2(0, x)}) {
      const auto key = tePatchAt(lattice, point);
      ASSERT_FALSE(key) << x;
      EXPECT_NE(key.error().message.find("outside the world"), std::string::npos);
    }
  EXPECT_FALSE(tePatchAt(lattice, {0, 0}, -1));
  EXPECT_FALSE(tePatchAt(lattice, {0, 0}, TePatchKey::kMaxLevel + 1));
  EXPECT_EQ(tePatchAt(lattice, {-32 * 0x1p47, 0})->x, -TeLattice::kMaxKey);
}

TEST(TePatchKey, PatchAtFindsThePatchOfItsOwnCentre) {
  TeRandom random(3, 1, {});
  for (int samples : {5, 7, 65, 129})
    for (double spacing : {1.0, 0.1, 27.3}) {
      const TeLattice lattice = *TeLattice::create(samples, spacing);
      for (int i = 0; i < 500; ++i) {
        const int level = int(random.below(20));
        const std::int64_t range = std::int64_t(1) << (41 - level);
        const TePatchKey key{std::int64_t(random.below(std::uint64_t(range))) - range / 2,
                             std::int64_t(random.below(std::uint64_t(range))) - range / 2, level};
        EXPECT_EQ(*tePatchAt(lattice, tePatchCentre(lattice, key), level), key) << key.text();
      }
    }
}
