#include "patchdb/TePatchKey.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <limits>

// The outermost keys of every level, one beyond them, and the extreme integers: every step gives a valid key
// that leads back, or an error; under UBSan nothing overflows.
TEST(HardCase, KeyOverflow) {
  long roundTrips = 0;
  long errors = 0;
  const std::int64_t extremes[] = {
      std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::min() + 1,
      std::numeric_limits<std::int64_t>::max() - 1, std::numeric_limits<std::int64_t>::max()};
  for (int level = -1; level <= TePatchKey::kMaxLevel + 1; ++level) {
    const std::int64_t limit = level < 0 ? 1 : TeLattice::kMaxKey >> std::min(level, 62);
    for (std::int64_t y : {-limit - 1, -limit, std::int64_t(0), limit - 1, limit, extremes[0], extremes[3]})
      for (std::int64_t x :
           {-limit - 1, -limit, std::int64_t(-1), limit - 1, limit, extremes[1], extremes[2]}) {
        const TePatchKey key{x, y, level};
        const bool exists = level >= 0 && level <= TePatchKey::kMaxLevel && x >= -limit && x < limit &&
                            y >= -limit && y < limit;
        ASSERT_EQ(key.valid(), exists) << key.text();
        const TeResult<TePatchKey> parent = key.parent();
        ASSERT_EQ(parent.ok(), exists && level < TePatchKey::kMaxLevel) << key.text();
        if (parent) {
          ASSERT_TRUE(parent->valid());
          ASSERT_EQ(*parent->child(key.childIndex()), key);
        }
        for (int index = 0; index < 4; ++index) {
          const TeResult<TePatchKey> child = key.child(index);
          ASSERT_EQ(child.ok(), exists && level > 0);
          if (child) {
            ASSERT_EQ(*child->parent(), key);
          }
        }
        for (TeDirection direction : kTeDirections) {
          const TeResult<TePatchKey> next = key.neighbour(direction);
          ASSERT_TRUE(!next || (exists && next->valid()));
          if (next) {
            ASSERT_EQ(*next->neighbour(teOpposite(direction)), key);
          }
          next ? ++roundTrips : ++errors;
        }
        for (int at = -1; at <= TePatchKey::kMaxLevel + 1; ++at)
          ASSERT_EQ(key.ancestor(at).ok(), exists && at >= level && at <= TePatchKey::kMaxLevel);
      }
  }
  // Up to the top and down again, by every corner of the world.
  for (std::int64_t y : {-TeLattice::kMaxKey, TeLattice::kMaxKey - 1})
    for (std::int64_t x : {-TeLattice::kMaxKey, TeLattice::kMaxKey - 1}) {
      TePatchKey key{x, y, 0};
      int path[TePatchKey::kMaxLevel];
      for (int level = 0; level < TePatchKey::kMaxLevel; ++level) {
        path[level] = key.childIndex();
        key = *key.parent();
      }
      ASSERT_EQ(key, (TePatchKey{x < 0 ? -1 : 0, y < 0 ? -1 : 0, TePatchKey::kMaxLevel}));
      ASSERT_FALSE(key.parent());
      for (int level = TePatchKey::kMaxLevel; level-- > 0;)
        key = *key.child(path[level]);
      ASSERT_EQ(key, (TePatchKey{x, y, 0}));
    }
  std::printf("KeyOverflow: %ld steps lead back, %ld are errors, levels -1 to %d\n", roundTrips, errors,
              TePatchKey::kMaxLevel + 1);
}
