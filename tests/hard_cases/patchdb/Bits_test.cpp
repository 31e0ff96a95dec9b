#include "generators/base/TeHash.h"
#include "patchdb/TeFourMapBlend.h"
#include "patchdb/TeSurfaceNormals.h"

#include <gtest/gtest.h>

#include <cinttypes>
#include <cstdio>
#include <vector>

namespace {

/// Heights of -4096 to 4096 m in steps of 2^-11, exact in float.
TeHeightMap madeOfHashes(int side, std::uint64_t seed) {
  TeHeightMap map = *TeHeightMap::create(side, side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      map.at(x, y) =
          float(teMix(seed * 1000003 + std::uint64_t(y) * 4099 + std::uint64_t(x)) >> 40) * 0x1p-11f -
          4096.0f;
  return map;
}

} // namespace

// Blended heights and normals have the same bits whatever the compiler, its optimisation and the instruction
// set, for sizes with and without a power of two and for rows that no vector divides.
TEST(HardCase, BitsPatchdb) {
  std::uint64_t hash = 0;
  for (int side : {5, 7, 19, 65, 101, 257}) {
    const int n = (side - 1) / 2;
    TeHeightMap patch = *TeHeightMap::create(n + 1, n + 1);
    const TeHeightMap maps[4] = {madeOfHashes(side, 1), madeOfHashes(side, 2), madeOfHashes(side, 3),
                                 madeOfHashes(side, 4)};
    for (TeBlendProfile profile : {TeBlendProfile::Linear, TeBlendProfile::Smooth}) {
      const TeBlendWeights weights(n, profile);
      TeFourMapBlend(weights, maps[0], maps[1], maps[2], maps[3], patch).finish();
      hash = teHashBytes(patch.data(), patch.bytes(), hash);
    }
    std::vector<glm::vec3> normals(std::size_t(n - 1) * std::size_t(n - 1));
    for (double spacing : {1.0, 0.1, 90.0}) {
      teGridNormals(patch.row(1) + 1, n + 1, n - 1, n - 1, spacing, false, normals.data());
      hash = teHashBytes(normals.data(), normals.size() * sizeof(glm::vec3), hash);
    }
  }
  std::printf("BitsPatchdb: heights and normals of six sizes hash to %016" PRIx64 "\n", hash);
  EXPECT_EQ(hash, 0x22d35694e15cc074ull);
}
