#include "generators/base/TeRandom.h"
#include "patchdb/TeTestWorlds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

// Rays that must cross the surface: down and up, steep and grazing, on and along every grid line, every patch
// border and the diagonals, through samples, at steps of 10 to 10^4 m: always hit.
TEST(HardCase, TunnellingPatchdb) {
  long rays = 0;
  // Patches of one, of 4×4 and of 2×2×8×8 blocks of cells.
  for (const auto& shape : {std::pair(1.0, 8), {0.1, 8}, {27.3, 8}, {1.0, 32}, {0.7, 65}}) {
    const double spacing = shape.first;
    const int n = shape.second;
    auto database = teTestDatabase(std::make_shared<TeHashSource>(3, float(2 * spacing)), 2 * n + 1, spacing);
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x)
        ASSERT_TRUE(database->build({x, y, 0}));
    const TeLattice& lattice = database->lattice();
    const double top = 3 * spacing;
    const auto cross = [&](glm::dvec2 from, glm::dvec2 to, double low, double high, double stretch) {
      for (bool down : {true, false}) {
        const glm::dvec3 a(from, down ? high : low);
        const glm::dvec3 b(to, down ? low : high);
        const auto hit = database->intersect(a, (b - a) / stretch, stretch);
        ASSERT_TRUE(hit) << a.x << " " << a.y << " " << a.z << " to " << b.x << " " << b.y << " " << b.z;
        ASSERT_NEAR(hit->position.z, *database->heightAt({hit->position.x, hit->position.y}), 1e-6 * spacing);
        ++rays;
      }
    };
    const double west = lattice.position(-n), east = lattice.position(2 * n);
    for (int line = -n; line <= 2 * n; ++line) {
      const double at = lattice.position(line);
      // Down at every crossing of grid lines, and falls of 10 to 10^4 m a step.
      for (int other = -n; other <= 2 * n; ++other) {
        const glm::dvec2 p(at, lattice.position(other));
        cross(p, p, -10 - top, 10 + top, 1);
        for (double speed : {10.0, 100.0, 1000.0, 10000.0})
          cross(p, p, -top - speed / 2, top + speed / 2, 1);
      }
      // Along the grid line and, with ever smaller slopes, across it.
      cross({at, west}, {at, east}, -top, top, 1);
      cross({west, at}, {east, at}, -top, top, 1000);
      for (double off : {1e-300, 1e-18, 1e-12, 1e-6, 1e-3})
        for (double sign : {-1.0, 1.0}) {
          const double to = std::min(std::max(at + sign * off * spacing, west), east);
          cross({at, west}, {to, east}, -top, top, 3);
          cross({east, to}, {west, at}, -top, top, 3);
        }
      // Diagonally through samples.
      const double back = lattice.position(n - line);
      cross({at, west}, {east, back}, -top, top, 1);
      cross({west, at}, {back, east}, -top, top, 1);
      cross({at, east}, {at, west}, -1e4, 1e4, 1);
    }
    TeRandom random(5, 5, {});
    for (int i = 0; i < 20000; ++i) {
      const glm::dvec2 a(random.uniform(west, east), random.uniform(west, east));
      const glm::dvec2 b(random.uniform(west, east), random.uniform(west, east));
      cross(a, b, -top, top, 1);
    }
    if (HasFatalFailure())
      return;
  }
  std::printf("TunnellingPatchdb: %ld rays on grid lines, borders, diagonals and at random, 0 missed\n",
              rays);
}

// A hole on one side of a grid line does not let a ray along that line through on the other side.
TEST(HardCase, TunnellingBesideHoles) {
  long rays = 0;
  for (int line : {-8, -4, 0, 3, 8}) {
    auto database = teSampleWorld(
        [line](std::int64_t x, std::int64_t) { return x > line ? TeHeightMap::missing() : 0.0f; }, 17);
    for (int y = -1; y <= 1; ++y)
      for (int x = -2; x <= 1; ++x)
        ASSERT_TRUE(database->build({x, y, 0}));
    const double at = database->lattice().position(line);
    for (double slope : {0.1, 1.0, 100.0})
      for (double from = -8; from < 8; from += 0.5) {
        const auto hit = database->intersect({at, from, slope}, {0, 1, -slope}, 10);
        ASSERT_TRUE(hit) << line << " " << from;
        EXPECT_DOUBLE_EQ(hit->distance, 1);
        ++rays;
      }
    ASSERT_TRUE(database->intersect({at, 0, 5}, {0, 0, -1}, 10));
  }
  std::printf("TunnellingBesideHoles: %ld rays along the rim, 0 missed\n", rays);
}
