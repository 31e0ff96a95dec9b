#include "patchdb/TeMeshCensus.h"
#include "patchdb/TeTestWorlds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

// Perfectly flat worlds, at heights of every size, and spacings of every size: normals are exactly up, no
// triangle lacks area, and rays within the plane of the ground end.
TEST(HardCase, ZeroArea) {
  long normals = 0;
  for (float height : {0.0f, -0.0f, 1e-45f, 1234.5f, -11034.0f, 3.4028234e38f})
    for (double spacing : {1e-6, 0.1, 1.0, 30.0, 1e6}) {
      auto database = teSampleWorld([height](std::int64_t, std::int64_t) { return height; }, 17, spacing);
      for (int y = -1; y <= 0; ++y)
        for (int x = -1; x <= 0; ++x)
          ASSERT_TRUE(database->build({x, y, 0}));
      TeMeshCensus census;
      for (const TePatchMesh& mesh : teBlockMeshes(*database, {-1, -1, 0}, 2, 2)) {
        ASSERT_TRUE(census.add(mesh));
        for (const glm::vec3& normal : mesh.normals) {
          ASSERT_EQ(normal, glm::vec3(0, 0, 1));
          ++normals;
        }
      }
      for (const TeMeshCensus::Triangle& triangle : census.triangles())
        ASSERT_GT(triangle.areaInPlan(), 0);
      EXPECT_EQ(*database->normalAt({0.3 * spacing, -0.7 * spacing}), glm::dvec3(0, 0, 1));
      EXPECT_EQ(*database->heightAt({0.3 * spacing, -0.7 * spacing}), double(height));
      EXPECT_TRUE(database->intersect({0, 0, height}, {1, 1, 0}, INFINITY));
      EXPECT_TRUE(database->intersect({-1e9, 0, height}, {1, 0, 0}, INFINITY));
      EXPECT_FALSE(database->intersect({-1e9, 0, double(height) + 2 + std::fabs(double(height))}, {1, 0, 0},
                                       INFINITY));
    }
  std::printf("ZeroArea: %ld normals of flat ground, all exactly (0, 0, 1)\n", normals);
}
