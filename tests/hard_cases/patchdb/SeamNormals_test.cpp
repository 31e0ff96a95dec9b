#include "generators/base/TeRandom.h"
#include "patchdb/TeBlendWeights.h"
#include "patchdb/TeSurfaceNormals.h"
#include "patchdb/TeTestWorlds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstring>

// Every vertex of patches, seams and corners has the normal of the surface as a whole, computed from the
// samples of one big grid; so both sides agree, and the weights behind the heights sum to exactly 1.
TEST(HardCase, SeamNormals) {
  const int n = 8;
  const int patches = 4;
  auto database = teTestDatabase(std::make_shared<TeHashSource>(), 2 * n + 1, 1.0);
  for (int y = 0; y < patches; ++y)
    for (int x = 0; x < patches; ++x)
      ASSERT_TRUE(database->build({x, y, 0}));
  const auto height = [&](std::int64_t x, std::int64_t y) {
    return database->find({x / n, y / n, 0})->heights().at(int(x % n), int(y % n));
  };
  long vertices = 0;
  for (int y = 0; y < patches - 1; ++y)
    for (int x = 0; x < patches - 1; ++x) {
      const TePatchData& patch = *database->find({x, y, 0});
      std::vector<TePatchMesh> meshes = {*database->patchMesh(patch)};
      for (TeDirection direction : {TeDirection::East, TeDirection::North, TeDirection::NorthEast}) {
        meshes.push_back(*database->seamMesh(patch, direction));
        // The patches on the other side are given the same bits.
        const TePatchData& other = *patch.neighbour(direction);
        const TePatchMesh same = *database->seamMesh(other, teOpposite(direction));
        ASSERT_EQ(std::memcmp(same.normals.data(), meshes.back().normals.data(),
                              same.normals.size() * sizeof(glm::vec3)),
                  0);
      }
      for (const TePatchMesh& mesh : meshes)
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
          const glm::dvec3 at = mesh.origin + glm::dvec3(mesh.positions[v]);
          const std::int64_t gx = std::int64_t(at.x + n / 2);
          const std::int64_t gy = std::int64_t(at.y + n / 2);
          const glm::vec3 expected = teSampleNormal(height(gx, gy), height(gx - 1, gy), height(gx + 1, gy),
                                                    height(gx, gy - 1), height(gx, gy + 1), 1.0);
          ASSERT_EQ(std::memcmp(&mesh.normals[v], &expected, sizeof expected), 0) << gx << ", " << gy;
          ++vertices;
        }
    }
  const TeBlendWeights smooth(n, TeBlendProfile::Smooth);
  long weights = 0;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) {
      std::int64_t sum = 0;
      for (int map = 0; map < 4; ++map)
        sum += smooth.weight(map, x, y);
      ASSERT_EQ(sum, std::int64_t(smooth.whole()) * smooth.whole());
      ++weights;
    }
  std::printf("SeamNormals: %ld vertex normals and %ld sums of weights, 0 bits differ\n", vertices, weights);
}
