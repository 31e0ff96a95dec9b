#include "nodes/seamless/TeSeamlessBounds.h"

#include "nodes/seamless/TeSeamlessMesh.h"
#include "nodes/seamless/stressHeights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace {

using BoundsPtr = std::shared_ptr<const TeSeamlessBounds>;

class MapHeights : public TeSeamlessHeights {
public:
  explicit MapHeights(const TeHeightMap& map) : m_map(map) {}
  float height(std::int32_t column, std::int32_t row, int) const override { return m_map.at(column, row); }

private:
  const TeHeightMap& m_map;
};

TeSeamlessLayout layoutOf(int resolution, int minResolution, int levels) {
  return TeSeamlessLayout::create(resolution, minResolution, levels).value();
}

BoundsPtr boundsOf(const TeSeamlessLayout& layout, const TeHeightMap& map) {
  return TeSeamlessBounds::create(layout, map).value();
}

/// Calls give(column, row, height) for every sample in a triangle, with the height of the triangle.
template <class Give> void forEachSample(const TeSeamlessMesh::Triangle& triangle, const Give& give) {
  const auto& [a, b, c, strip] = triangle;
  const auto turn = [](double x0, double y0, double x1, double y1) { return x0 * y1 - x1 * y0; };
  const double area = turn(b.column - a.column, b.row - a.row, c.column - a.column, c.row - a.row);
  ASSERT_GT(area, 0);
  for (int y = std::min({a.row, b.row, c.row}); y <= std::max({a.row, b.row, c.row}); y++)
    for (int x = std::min({a.column, b.column, c.column}); x <= std::max({a.column, b.column, c.column});
         x++) {
      const double ofB = turn(x - a.column, y - a.row, c.column - a.column, c.row - a.row);
      const double ofC = turn(b.column - a.column, b.row - a.row, x - a.column, y - a.row);
      const double ofA = area - ofB - ofC;
      if (ofA >= 0 && ofB >= 0 && ofC >= 0)
        give(x, y, (ofA * double(a.height) + ofB * double(b.height) + ofC * double(c.height)) / area);
    }
}

/// Largest deviation of a patch by side: over the quarter of the patch that lies at the side.
std::array<double, 4> deviations(const TeSeamlessPatch& patch, const TeSeamlessLayout& layout,
                                 const TeSeamlessParts& parts, const TeHeightMap& map) {
  std::vector<TeSeamlessMesh::Triangle> triangles;
  TeSeamlessMesh::appendPatch(patch, layout, parts, MapHeights(map), triangles);
  std::array<double, 4> largest{};
  const int size = layout.cells(patch.level);
  for (const TeSeamlessMesh::Triangle& triangle : triangles)
    forEachSample(triangle, [&](int column, int row, double height) {
      const int x = column - patch.x * size, y = row - patch.y * size;
      const std::array<int, 4> distance{size - y, size - x, y, x};
      const int nearest = *std::min_element(distance.begin(), distance.end());
      for (std::size_t side = 0; side < 4; side++)
        if (distance[side] == nearest)
          largest[side] = std::max(largest[side], std::fabs(double(map.at(column, row)) - height));
    });
  return largest;
}

TeSideBounds sideOf(const TeSeamlessBounds& bounds, const TeSeamlessPatch& patch, std::size_t side) {
  return bounds.side(TeSeamlessLayout::sideOf(patch.level, patch.x, patch.y, TeSide(side)));
}

const std::vector<std::array<int, 3>> kLayouts = {{64, 4, 3},  {64, 2, 2},  {32, 2, 5}, {32, 16, 2},
                                                  {128, 4, 4}, {128, 8, 3}, {16, 16, 3}};

template <class Check> void forEachTerrain(const Check& check) {
  for (const auto& [resolution, minResolution, levels] : kLayouts)
    for (const std::string& kind : stressKinds()) {
      SCOPED_TRACE(kind + " " + std::to_string(resolution) + " " + std::to_string(minResolution) + " " +
                   std::to_string(levels));
      const TeSeamlessLayout layout = layoutOf(resolution, minResolution, levels);
      const TeHeightMap map = stressHeights(kind, resolution);
      check(layout, map, *boundsOf(layout, map), kind);
      if (testing::Test::HasFailure())
        return;
    }
}

} // namespace

// However a patch is drawn, no sample is off by more than the error of the side that it is nearest to.
TEST(TeSeamlessBounds, boundsEveryDrawing) {
  TeRandom random(1, 0, TeMapKey{});
  forEachTerrain([&](const TeSeamlessLayout& layout, const TeHeightMap& map, const TeSeamlessBounds& bounds,
                     const std::string& kind) {
    const TeSeamlessParts parts(layout);
    // Morphed heights are floats: those of whole numbers are rounded too where the weight is odd.
    const double rounding = kind == "fractions" ? 2e-4 : kind == "flat" ? 0 : 0.01;
    for (int trial = 0; trial < 60; trial++) {
      TeSeamlessPatch patch;
      patch.level = std::int16_t(random.below(std::uint64_t(layout.depth())));
      patch.x = std::int32_t(random.below(std::uint64_t(layout.patchesPerSide(patch.level))));
      patch.y = std::int32_t(random.below(std::uint64_t(layout.patchesPerSide(patch.level))));
      const int top = layout.topIndex(patch.level);
      for (float& detail : patch.detail) {
        detail = float(random.uniform(0, top));
        if (random.below(3) == 0)
          detail = std::round(detail);
      }
      const std::array<double, 4> largest = deviations(patch, layout, parts, map);
      for (std::size_t side = 0; side < 4; side++)
        ASSERT_LE(largest[side],
                  double(sideOf(bounds, patch, side).error[int(patch.detail[side])]) + rounding)
            << "level " << patch.level << ", side " << side << ", details " << patch.detail[0] << " "
            << patch.detail[1] << " " << patch.detail[2] << " " << patch.detail[3];
    }
  });
}

// Nothing is drawn finer than needed: each error is reached by a drawing that it stands for.
TEST(TeSeamlessBounds, errorsAreReached) {
  forEachTerrain([&](const TeSeamlessLayout& layout, const TeHeightMap& map, const TeSeamlessBounds& bounds,
                     const std::string& kind) {
    if (layout.resolution() > 64 || kind == "fractions")
      return;
    const TeSeamlessParts parts(layout);
    const int level = layout.depth() - 1;
    const int top = layout.topIndex(level);
    std::vector<std::vector<double>> reached(std::size_t(layout.sideCount(level)),
                                             std::vector<double>(std::size_t(top) + 1));
    for (std::int32_t y = 0; y < layout.patchesPerSide(level); y++)
      for (std::int32_t x = 0; x < layout.patchesPerSide(level); x++)
        for (int index = 0; index <= top; index++)
          for (int other = 0; other <= top; other++)
            for (const float morph : {0.0f, 0.001f})
              for (const std::size_t odd : {0, 1}) {
                TeSeamlessPatch patch{std::int16_t(level), x, y, {}};
                patch.detail.fill(float(other));
                patch.detail[odd] = patch.detail[odd + 2] = std::min(float(top), float(index) + morph);
                const std::array<double, 4> largest = deviations(patch, layout, parts, map);
                for (const std::size_t side : {odd, odd + 2}) {
                  const std::int64_t key =
                      layout.sideIndex(TeSeamlessLayout::sideOf(level, x, y, TeSide(side)));
                  for (int i = 0; i <= index; i++) {
                    double& most = reached[std::size_t(key)][std::size_t(i)];
                    most = std::max(most, largest[side]);
                  }
                }
              }
    for (std::int32_t y = 0; y < layout.patchesPerSide(level); y++)
      for (std::int32_t x = 0; x < layout.patchesPerSide(level); x++)
        for (const TeSide at : {TeNorth, TeEast, TeSouth, TeWest}) {
          const TeSideKey side = TeSeamlessLayout::sideOf(level, x, y, at);
          for (int i = 0; i <= top; i++)
            ASSERT_NEAR(bounds.side(side).error[i],
                        reached[std::size_t(layout.sideIndex(side))][std::size_t(i)],
                        bounds.side(side).error[i] * 1e-6)
                << x << " " << y << " side " << at << " index " << i;
        }
  });
}
