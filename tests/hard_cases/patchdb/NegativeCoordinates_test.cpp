#include "patchdb/TePatchKey.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

// Points over [-3s, 3s] in every octant, s = a patch's side: the key by floor division, the same by the
// recursive way over parents, children and neighbours.
TEST(HardCase, NegativeCoordinates) {
  long checks = 0;
  for (int samples : {5, 7, 65}) {
    const TeLattice lattice = *TeLattice::create(samples, 1.0);
    const double side = lattice.patchSide();
    for (int j = -24; j <= 24; ++j)
      for (int i = -24; i <= 24; ++i) {
        const glm::dvec2 point{i * side / 8, j * side / 8};
        const TePatchKey key = *tePatchAt(lattice, point);
        ASSERT_EQ(key.x, std::int64_t(std::floor(point.x / side + 0.5)));
        ASSERT_EQ(key.y, std::int64_t(std::floor(point.y / side + 0.5)));
        const glm::dvec2 local = point - tePatchOrigin(lattice, key);
        ASSERT_TRUE(local.x >= 0 && local.x < side && local.y >= 0 && local.y < side);
        ++checks;
      }
  }
  for (int level = 0; level <= 3; ++level)
    for (std::int64_t y = -24; y <= 24; ++y)
      for (std::int64_t x = -24; x <= 24; ++x) {
        const TePatchKey key{x, y, level};
        const TePatchKey parent = *key.parent();
        ASSERT_EQ(parent.x, std::int64_t(std::floor(double(x) / 2)));
        ASSERT_EQ(parent.y, std::int64_t(std::floor(double(y) / 2)));
        ASSERT_EQ(*parent.child(key.childIndex()), key);
        ASSERT_TRUE(parent.contains(key) && !key.contains(parent));
        for (TeDirection direction : kTeDirections) {
          const TePatchKey next = *key.neighbour(direction);
          ASSERT_EQ(next.x - x, teStep(direction).x);
          ASSERT_EQ(next.y - y, teStep(direction).y);
          ASSERT_EQ(*next.neighbour(teOpposite(direction)), key);
          ASSERT_FALSE(key.contains(next));
          ++checks;
        }
      }
  std::printf("NegativeCoordinates: %ld checks, 0 differ\n", checks);
}
