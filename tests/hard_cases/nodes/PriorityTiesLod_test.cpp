#include "nodes/lod/LodTest.h"

#include <array>
#include <cstdio>
#include <vector>

namespace {

constexpr int kCells = 64;

/// Everything alike in all directions, or all the same.
TeHeightMap tiedMap(int kind) {
  TeHeightMap map = TeHeightMap::create(kCells + 1, kCells + 1).value();
  for (int y = 0; y <= kCells; y++)
    for (int x = 0; x <= kCells; x++)
      map.at(x, y) = kind == 0   ? 7.0f
                     : kind == 1 ? float((x + y) % 2 * 5)
                                 : float((x % 8 == 0) + (y % 8 == 0));
  return map;
}

using Triangle = std::array<std::array<float, 3>, 3>;

/// Sorted; the order in which they are drawn may differ.
std::vector<Triangle> trianglesOf(const TeLodMesh& mesh) {
  std::vector<Triangle> triangles(mesh.indices.size() / 3);
  for (std::size_t i = 0; i < mesh.indices.size(); i++) {
    const TeLodVertex& vertex = mesh.vertices[mesh.indices[i]];
    triangles[i / 3][i % 3] = {float(vertex.column), float(vertex.row), vertex.height};
  }
  for (Triangle& triangle : triangles)
    std::sort(triangle.begin(), triangle.end());
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

} // namespace

// Where all errors are equal nothing but the key may decide: whatever was seen before, in whatever order, the
// same view selects the same triangles.
LOD_TEST(HardCase, PriorityTiesLod) {
  std::mt19937 random(21);
  int compared = 0;
  for (int kind = 0; kind < 3; kind++) {
    const TeLodFieldPtr field = lodField(tiedMap(kind));
    std::vector<TeLodView> history;
    for (int i = 0; i < 12; i++)
      history.push_back(anyView(random, *field));
    const TeLodView last = viewFrom({kCells / 2, kCells / 2, 40});
    for (const double wanted : {0.5, 8.0, 60.0}) {
      TeLodAccuracy accuracy;
      accuracy.pixelError = wanted;
      std::vector<Triangle> expected;
      for (int shuffle = 0; shuffle < 5; shuffle++) {
        SCOPED_TRACE(testing::Message() << "field " << kind << ", " << wanted << " px, order " << shuffle);
        const std::unique_ptr<TeLodMethod> method = lodMethod(name, field);
        ASSERT_TRUE(method);
        std::shuffle(history.begin(), history.end(), random);
        for (int i = 0; i < 3 * shuffle; i++) // none, the first time
          method->select(history[std::size_t(i)], accuracy);
        method->select(last, accuracy);
        LodFrame frame(field);
        frame.take(*method);
        const std::vector<Triangle> triangles = trianglesOf(frame.mesh());
        if (shuffle == 0)
          expected = triangles;
        ASSERT_EQ(triangles, expected);
        compared++;
      }
    }
  }
  std::printf("%s: %d selections after shuffled histories, the same triangles\n", name.c_str(), compared);
}
