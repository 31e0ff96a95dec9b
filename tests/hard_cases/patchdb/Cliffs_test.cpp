#include "patchdb/TeTestWorlds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

// A step of 10 km within one cell, across patches and along their borders: normals are finite and of unit
// length, triangles meet, height queries and rays find the wall.
TEST(HardCase, Cliffs) {
  double worst = 0;
  long vertices = 0;
  for (int at : {0, 1, 3, 7, 8, 9}) {
    auto database = teSampleWorld(
        [at](std::int64_t x, std::int64_t y) { return (x < at) != (y < at) ? 10000.0f : 0.0f; }, 17);
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x)
        ASSERT_TRUE(database->build({x, y, 0}));
    const TePatchData& middle = *database->find({0, 0, 0});
    std::vector<TePatchMesh> meshes = {*database->patchMesh(middle)};
    for (TeDirection direction : kTeDirections)
      meshes.push_back(*database->seamMesh(middle, direction));
    for (const TePatchMesh& mesh : meshes)
      for (const glm::vec3& normal : mesh.normals) {
        ASSERT_TRUE(std::isfinite(normal.x) && std::isfinite(normal.y) && std::isfinite(normal.z));
        const double length = std::sqrt(double(normal.x) * normal.x + double(normal.y) * normal.y +
                                        double(normal.z) * normal.z);
        worst = std::max(worst, std::fabs(length - 1));
        ASSERT_GT(normal.z, 0);
        ++vertices;
      }
    // Halfway up the wall, from both sides.
    const double wall = database->lattice().position(at) - 0.5;
    const double along = database->lattice().position(at - 3);
    EXPECT_EQ(*database->heightAt({wall, along}), 5000.0);
    for (double side : {-2.0, 2.0}) {
      const auto hit = database->intersect({wall + side, along, 5000}, {-side, 0, 0}, 10);
      ASSERT_TRUE(hit);
      EXPECT_NEAR(hit->position.x, wall, 1e-9);
      EXPECT_NEAR(hit->position.z, 5000, 1e-9);
    }
  }
  EXPECT_LT(worst, 1e-6);
  std::printf("Cliffs: 10 km in one cell, %ld normals finite, length off by at most %.1e\n", vertices, worst);
}
