#include "patchdb/TeMeshCensus.h"
#include "patchdb/TeTestWorlds.h"

#include <gtest/gtest.h>

#include <cstdio>

// Map sizes 0 .. 70 and large ones: a world of patches that tile, or an error.
TEST(HardCase, SizesPatchdb) {
  int accepted = 0;
  int refused = 0;
  std::vector<int> sizes = {127, 255, 513, -1, 1 << 20};
  for (int size = 0; size <= 70; ++size)
    sizes.push_back(size);
  for (int size : sizes) {
    if (!TeLattice::create(size, 1.0)) {
      ++refused;
      continue;
    }
    auto database = teTestDatabase(std::make_shared<TeHashSource>(), size);
    for (int y = 0; y < 2; ++y)
      for (int x = 0; x < 2; ++x)
        ASSERT_TRUE(database->build({x, y, 0})) << size;
    std::size_t vertices = 0;
    std::size_t corners = 0;
    for (const TePatchMesh& mesh : teBlockMeshes(*database, {0, 0, 0}, 2, 2)) {
      ASSERT_EQ(mesh.positions.size(), std::size_t(mesh.columns) * std::size_t(mesh.rows));
      vertices += mesh.positions.size();
      corners += mesh.strips.size();
    }
    // Four insides, four seams, one corner square: each mesh counts its own rim.
    const std::size_t n = std::size_t(database->lattice().cells());
    const std::size_t inside = n > 2 ? (n - 1) * (n - 1) : 0;
    ASSERT_EQ(vertices, 4 * inside + (n > 2 ? 4 * 3 * (n - 1) : 0) + 9) << size;
    ASSERT_GT(corners, 0u);
    ++accepted;
  }
  EXPECT_EQ(accepted, 36); // 5, 7 .. 69 and three large ones
  std::printf("SizesPatchdb: %d sizes make worlds, %d are refused\n", accepted, refused);
}
