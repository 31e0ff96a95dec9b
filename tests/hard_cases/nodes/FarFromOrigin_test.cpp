#include "nodes/terrain/TeMeshVertices.h"

#include "generators/base/TeHash.h"
#include "nodes/testWorld.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace {

/// The same field wherever sample (shift, -shift) lies.
float field(std::int64_t x, std::int64_t y, std::int64_t shift) {
  const double column = double(x - shift);
  const double row = double(y + shift);
  return float(5 * std::sin(column * 0.21) + 3 * std::cos(row * 0.17 + column * 0.05));
}

/// Hash of what OpenGL gets of a block of 3×3 patches with its seams and corners, shifted by `shift` patches,
/// relative to an anchor two patches south-west of it.
std::uint64_t vertexHash(std::int64_t shift, double spacing) {
  const int n = 16;
  const auto source = std::make_shared<TeSampleFunction>(
      [=](std::int64_t x, std::int64_t y) { return field(x, y, shift * n); });
  const TeWorld world = worldOf(source, 2 * n + 1, spacing);
  const TePatchKey middle{shift, -shift, 0};
  const TeResult<TeStaticBlock> block = TeStaticBlock::build(world, tePatchCentre(world.lattice, middle), 3);
  EXPECT_TRUE(block) << (block ? "" : block.error().message);
  const glm::dvec2 anchor = tePatchOrigin(world.lattice, {shift - 3, -shift - 3, 0});
  std::uint64_t hash = 0;
  EXPECT_TRUE(block->forEachPiece([&](const TePatchMesh& mesh) {
    const std::vector<glm::vec3> positions = teMeshPositions(mesh, anchor);
    const std::vector<TeVertexAttributes> attributes = teMeshAttributes(mesh, {});
    hash = teHashBytes(positions.data(), positions.size() * sizeof(glm::vec3), hash);
    hash = teHashBytes(attributes.data(), attributes.size() * sizeof(TeVertexAttributes), hash);
  }));
  return hash;
}

} // namespace

// The vertex buffers of the same landscape, shifted by 2^k patches of 16 m, are the same bits: what is drawn
// does not depend on where in the world it is.
TEST(HardCase, FarFromOriginNodes) {
  const std::uint64_t here = vertexHash(0, 1);
  int places = 0;
  double farthest = 0;
  for (int k = 0; k <= 26; k++) { // 16 m · 2^26 = 1.07e9 m
    for (const std::int64_t sign : {1, -1}) {
      const std::int64_t shift = sign * (std::int64_t(1) << k);
      EXPECT_EQ(vertexHash(shift, 1), here) << shift;
      farthest = std::max(farthest, std::abs(double(shift) * 16));
      places++;
    }
  }
  std::printf("vertex buffers at %d places up to %.3g m: one hash, %016llx\n", places, farthest,
              static_cast<unsigned long long>(here));
}
