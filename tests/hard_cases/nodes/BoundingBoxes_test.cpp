#include "generators/base/TeRandom.h"
#include "nodes/seamless/SeamlessViews.h"
#include "nodes/seamless/TeSeamlessBounds.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <vector>

namespace {

/// A patch's box in samples and heights.
struct Box {
  std::int32_t column = 0;
  std::int32_t row = 0;
  std::int32_t size = 0;
  TeHeightRange heights;

  bool holds(const TeSeamlessMesh::Vertex& vertex) const {
    return vertex.column >= column && vertex.column <= column + size && vertex.row >= row &&
           vertex.row <= row + size && vertex.height >= heights.low && vertex.height <= heights.high;
  }
  bool isReached(const TeSeamlessMesh::Vertex& vertex) const {
    return vertex.height == heights.low || vertex.height == heights.high;
  }
};

/// Of a patch and all its ancestors.
std::vector<Box> boxesOf(const TeSeamlessBounds& bounds, TeSeamlessPatch patch) {
  std::vector<Box> boxes;
  for (; patch.level >= 0; patch.level--) {
    const std::int32_t size = bounds.layout().cells(patch.level);
    boxes.push_back({patch.x * size, patch.y * size, size, bounds.range(patch.level, patch.x, patch.y)});
    patch.x /= bounds.layout().branching();
    patch.y /= bounds.layout().branching();
  }
  return boxes;
}

} // namespace

// What is drawn of a patch lies in its box and in those of all its ancestors, so that a box out of view means
// that nothing is seen. At the highest resolution the box is touched: it is no larger than it must be.
TEST(HardCase, BoundingBoxes) {
  TeRandom random(12, 0, TeMapKey{});
  std::mt19937 spikes(12);
  std::int64_t vertices = 0, boxes = 0, outside = 0, loose = 0;
  for (const auto& [resolution, minResolution, levels] :
       std::vector<std::array<int, 3>>{{256, 4, 3}, {128, 2, 2}, {128, 2, 4}, {64, 16, 2}}) {
    const TeSeamlessLayout layout = *TeSeamlessLayout::create(resolution, minResolution, levels);
    const TeSeamlessParts parts(layout);
    for (int field = 0; field <= int(StressField::Flat); field++) {
      const TeHeightMap map = stressMap(StressField(field), resolution, spikes);
      const auto bounds = *TeSeamlessBounds::create(layout, map);
      std::vector<TeSeamlessMesh::Triangle> triangles;
      for (TeSeamlessPatch patch; patch.level < layout.depth(); patch.level++)
        for (patch.y = 0; patch.y < layout.patchesPerSide(patch.level); patch.y++)
          for (patch.x = 0; patch.x < layout.patchesPerSide(patch.level); patch.x++) {
            const float top = float(layout.topIndex(patch.level));
            const bool finest = random.below(2) == 0;
            for (float& detail : patch.detail)
              detail = finest ? top : float(random.uniform(0, double(top)));
            triangles.clear();
            TeSeamlessMesh::appendPatch(patch, layout, parts, TeSeamlessMapHeights(&map), triangles);
            const std::vector<Box> around = boxesOf(*bounds, patch);
            boxes += std::int64_t(around.size());
            bool reached = false;
            for (const TeSeamlessMesh::Triangle& triangle : triangles)
              for (const TeSeamlessMesh::Vertex* vertex : {&triangle.a, &triangle.b, &triangle.c}) {
                vertices++;
                reached = reached || around.front().isReached(*vertex);
                for (const Box& box : around)
                  outside += !box.holds(*vertex);
              }
            loose += finest && patch.level == layout.depth() - 1 && !reached;
          }
    }
  }
  EXPECT_EQ(outside, 0);
  EXPECT_EQ(loose, 0);
  std::printf("HardCase.BoundingBoxes: %lld vertices, %lld boxes of patches and ancestors, %lld outside\n",
              static_cast<long long>(vertices), static_cast<long long>(boxes),
              static_cast<long long>(outside));
}
