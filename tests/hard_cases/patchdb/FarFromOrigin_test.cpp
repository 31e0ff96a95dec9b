#include "patchdb/TeTestWorlds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstring>

namespace {

/// The same field wherever the base patch lies.
float field(std::int64_t x, std::int64_t y) {
  const std::uint64_t bits = teHashCombine(std::uint64_t(x), std::uint64_t(y));
  return float(bits >> 48) * 0x1p-8f;
}

std::uint64_t hashOf(const TePatchMesh& mesh) {
  std::uint64_t hash = teHashBytes(mesh.positions.data(), mesh.positions.size() * sizeof(glm::vec3));
  hash = teHashBytes(mesh.normals.data(), mesh.normals.size() * sizeof(glm::vec3), hash);
  return teHashBytes(mesh.strips.data(), mesh.strips.size() * sizeof(std::int32_t), hash);
}

/// Hash of all local arrays and answers of a 2×2 block at a place.
std::uint64_t hashAt(std::int64_t keyX, std::int64_t keyY, double spacing) {
  const int n = 16;
  auto database = teSampleWorld(
      [=](std::int64_t x, std::int64_t y) { return field(x - keyX * n, y - keyY * n); }, 2 * n + 1, spacing);
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 2; ++x)
      EXPECT_TRUE(database->build({keyX + x, keyY + y, 0}));
  const TePatchData& patch = *database->find({keyX, keyY, 0});
  const glm::dvec2 centre = tePatchCentre(database->lattice(), patch.key());
  const TePatchMesh inside = *database->patchMesh(patch);
  std::uint64_t hash = hashOf(inside);
  // Camera-relative placement, too.
  hash = teHashDouble(teHashDouble(hash, inside.origin.x - centre.x), inside.origin.y - centre.y);
  for (TeDirection direction : {TeDirection::East, TeDirection::North, TeDirection::NorthEast}) {
    const TePatchMesh seam = *database->seamMesh(patch, direction);
    hash = teHashCombine(hash, hashOf(seam));
    hash = teHashDouble(teHashDouble(hash, seam.origin.x - centre.x), seam.origin.y - centre.y);
  }
  for (int i = 0; i < 64; ++i) {
    const glm::dvec2 point = centre + spacing * glm::dvec2(i % 8 * 2.25 - 4, i / 8 * 2.25 - 4);
    const auto height = database->heightAt(point);
    const auto hit = database->intersect({point, 512}, {spacing, -0.5 * spacing, -256}, 100);
    if (!height || !hit) {
      ADD_FAILURE() << point.x << ", " << point.y;
      return 0;
    }
    hash = teHashDouble(teHashDouble(hash, *height), hit->distance);
    // The position itself is rounded to what a double holds there.
    const double exact = (point.x - centre.x) + hit->distance * spacing;
    EXPECT_NEAR(hit->position.x - centre.x, exact, std::fabs(point.x) * 0x1p-52 + 1e-12);
  }
  return hash;
}

} // namespace

// The same landscape shifted by 2^k patches in both directions: local arrays, placement relative to the
// camera, heights and rays have the same bits at the origin and 10^9 m away and beyond.
TEST(HardCase, FarFromOriginPatchdb) {
  double farthest = 0;
  int places = 0;
  for (double spacing : {1.0, 0.5, 4.0}) {
    const std::uint64_t reference = hashAt(0, 0, spacing);
    for (int k = 0; k <= 26; ++k)
      for (int sign : {-1, 1}) {
        const std::int64_t shift = sign * (std::int64_t(1) << k);
        ASSERT_EQ(hashAt(shift, -3 * shift, spacing), reference) << k << " " << spacing;
        farthest = std::max(farthest, 3.0 * std::fabs(double(shift)) * 16 * spacing);
        ++places;
      }
  }
  EXPECT_GT(farthest, 1e9);
  std::printf("FarFromOriginPatchdb: %d places up to %.2g m from the origin, 0 hashes differ\n", places,
              farthest);
}
