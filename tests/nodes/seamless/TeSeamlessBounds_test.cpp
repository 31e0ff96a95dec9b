#include "nodes/seamless/TeSeamlessBounds.h"

#include "generators/base/TeRandom.h"
#include "nodes/seamless/SeamlessViews.h"

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

const std::vector<StressField> kStressFields = {StressField::Rough,        StressField::Spike,
                                                StressField::Cliff,        StressField::Plateau,
                                                StressField::Checkerboard, StressField::Flat};

TeHeightMap fieldOf(StressField field, int resolution) {
  std::mt19937 random(4);
  return stressMap(field, resolution, random);
}

/// Of morphed heights, which are floats.
double roundingOf(const TeSeamlessBounds& bounds) {
  const TeHeightRange range = bounds.range(0, 0, 0);
  return 0x1p-22 * double(std::max(std::fabs(range.low), std::fabs(range.high)));
}

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
  TeSeamlessMesh::appendPatch(patch, layout, parts, TeSeamlessMapHeights(&map), triangles);
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

template <class Give> void forEachSide(const TeSeamlessLayout& layout, int level, const Give& give) {
  const std::int32_t n = layout.patchesPerSide(level);
  for (const bool horizontal : {true, false})
    for (std::int32_t y = 0; y < n + horizontal; y++)
      for (std::int32_t x = 0; x < n + !horizontal; x++)
        give(TeSideKey{level, horizontal, x, y});
}

struct Box {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

/// The box for TeSideBounds::beyond, within the terrain.
Box boxOf(const TeSeamlessBounds& bounds, const TeSideKey& key) {
  const TeSeamlessLayout& layout = bounds.layout();
  const double size = layout.cells(key.level), end = layout.resolution();
  const double across = bounds.beyondAcross(key.level), along = bounds.beyondAlong(key.level);
  const double dx = key.horizontal ? along : across, dy = key.horizontal ? across : along;
  const double x = key.x * size, y = key.y * size;
  return {std::max(0.0, x - dx), std::max(0.0, y - dy), std::min(end, (key.horizontal ? x + size : x) + dx),
          std::min(end, (key.horizontal ? y : y + size) + dy)};
}

/// Of the samples of a rectangle that are in the map.
TeHeightRange rangeOf(const TeHeightMap& map, int x0, int y0, int x1, int y1) {
  TeHeightRange range{std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()};
  for (int y = std::max(0, y0); y <= std::min(map.height() - 1, y1); y++)
    for (int x = std::max(0, x0); x <= std::min(map.width() - 1, x1); x++) {
      range.low = std::min(range.low, map.at(x, y));
      range.high = std::max(range.high, map.at(x, y));
    }
  return range;
}

const std::vector<std::array<int, 3>> kLayouts = {{64, 4, 3},  {64, 2, 2},  {32, 2, 5}, {32, 16, 2},
                                                  {128, 4, 4}, {128, 8, 3}, {16, 16, 3}};

template <class Check> void forEachTerrain(const Check& check) {
  for (const auto& [resolution, minResolution, levels] : kLayouts)
    for (const StressField field : kStressFields) {
      SCOPED_TRACE("field " + std::to_string(int(field)) + ", " + std::to_string(resolution) + " " +
                   std::to_string(minResolution) + " " + std::to_string(levels));
      const TeSeamlessLayout layout = layoutOf(resolution, minResolution, levels);
      const TeHeightMap map = fieldOf(field, resolution);
      check(layout, map, *boundsOf(layout, map), field);
      if (testing::Test::HasFailure())
        return;
    }
}

} // namespace

// However a patch is drawn, no sample is off by more than the error of the side that it is nearest to.
TEST(TeSeamlessBounds, BoundsEveryDrawing) {
  TeRandom random(1, 0, TeMapKey{});
  forEachTerrain([&](const TeSeamlessLayout& layout, const TeHeightMap& map, const TeSeamlessBounds& bounds,
                     StressField) {
    const TeSeamlessParts parts(layout);
    const double rounding = roundingOf(bounds);
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
TEST(TeSeamlessBounds, ErrorsAreReached) {
  forEachTerrain([&](const TeSeamlessLayout& layout, const TeHeightMap& map, const TeSeamlessBounds& bounds,
                     StressField) {
    if (layout.resolution() > 64)
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
                        reached[std::size_t(layout.sideIndex(side))][std::size_t(i)], roundingOf(bounds))
                << x << " " << y << " side " << at << " index " << i;
        }
  });
}

// A flank that is morphed down beside a diagonal that is not: a surface that no whole details have.
TEST(TeSeamlessBounds, MorphedFlanksCount) {
  const TeSeamlessLayout layout = layoutOf(128, 2, 4);
  const TeSeamlessParts parts(layout);
  for (const bool mirrored : {false, true}) {
    TeHeightMap map = TeHeightMap::create(129, 129).value();
    map.at(64 + (mirrored ? 40 : 24), 64 + (mirrored ? 40 : 24)) = 1000;
    map.at(64 + (mirrored ? 36 : 12), 64 + (mirrored ? 52 : 28)) = -900;
    map.at(64 + (mirrored ? 32 : 0), 64 + (mirrored ? 64 : 32)) = -1000; // on the flank
    const BoundsPtr bounds = boundsOf(layout, map);
    TeSeamlessPatch patch;
    patch.detail = {0.001f, 3, 0, 0};
    const double morphed = deviations(patch, layout, parts, map)[TeNorth];
    double whole = 0;
    for (int first = 0; first <= 3; first++)
      for (int second = 0; second <= 3; second++) {
        patch.detail = {float(first), float(second), 0, float(second)};
        whole = std::max(whole, deviations(patch, layout, parts, map)[TeNorth]);
      }
    EXPECT_GT(morphed, whole + 200);
    EXPECT_EQ(sideOf(*bounds, patch, TeNorth).error[0], float(morphed));
  }
}

TEST(TeSeamlessBounds, ErrorsFallToNothing) {
  forEachTerrain([&](const TeSeamlessLayout& layout, const TeHeightMap&, const TeSeamlessBounds& bounds,
                     StressField field) {
    for (int level = 0; level < layout.depth(); level++)
      forEachSide(layout, level, [&](const TeSideKey& key) {
        const TeSideBounds side = bounds.side(key);
        const int top = layout.topIndex(level);
        for (int i = 1; i < layout.levels(); i++) {
          ASSERT_LE(side.error[i], side.error[i - 1]);
          ASSERT_EQ(side.error[std::max(i, top)], side.error[top]);
        }
        if (layout.spacingLog(level, top) == 0 || field == StressField::Flat) {
          ASSERT_EQ(side.error[top], 0);
        }
      });
  });
}

TEST(TeSeamlessBounds, RangesAreThoseOfTheSamples) {
  forEachTerrain([&](const TeSeamlessLayout& layout, const TeHeightMap& map, const TeSeamlessBounds& bounds,
                     StressField) {
    for (int level = 0; level < layout.depth(); level++) {
      const int size = layout.cells(level);
      for (int y = 0; y < layout.patchesPerSide(level); y++)
        for (int x = 0; x < layout.patchesPerSide(level); x++)
          ASSERT_TRUE(bounds.range(level, x, y) ==
                      rangeOf(map, x * size, y * size, (x + 1) * size, (y + 1) * size));
      forEachSide(layout, level, [&](const TeSideKey& key) {
        const int x = key.x * size, y = key.y * size;
        const TeHeightRange both =
            rangeOf(map, key.horizontal ? x : x - size, key.horizontal ? y - size : y, x + size, y + size);
        ASSERT_TRUE(bounds.side(key).range == both);
        if (level + 1 < layout.depth()) {
          const Box box = boxOf(bounds, key);
          ASSERT_TRUE(bounds.side(key).beyondRange ==
                      rangeOf(map, int(box.x0), int(box.y0), int(box.x1), int(box.y1)));
        }
      });
    }
  });
}

// What lets the selector divide a patch without asking its neighbours.
TEST(TeSeamlessBounds, BeyondIsNested) {
  forEachTerrain(
      [&](const TeSeamlessLayout& layout, const TeHeightMap&, const TeSeamlessBounds& bounds, StressField) {
        forEachSide(layout, layout.depth() - 1,
                    [&](const TeSideKey& key) { ASSERT_EQ(bounds.side(key).beyond, 0); });
        const int b = layout.branching();
        for (int level = 0; level + 1 < layout.depth(); level++)
          forEachSide(layout, level, [&](const TeSideKey& key) {
            const TeSideBounds side = bounds.side(key);
            const Box box = boxOf(bounds, key);
            ASSERT_GE(side.beyond, side.error[layout.topIndex(level)]);
            const double half = layout.cells(level) / 2;
            ASSERT_GE(bounds.beyondAcross(level), half); // what is drawn for the side at its top
            int parts = 0;
            const int n = layout.patchesPerSide(level + 1);
            for (int y = 0; y < n; y++)
              for (int x = 0; x < n; x++)
                for (const TeSide shared : {TeNorth, TeEast, TeSouth, TeWest}) {
                  const TeSideKey part = TeSeamlessLayout::sideOf(level + 1, x, y, shared);
                  if (part.horizontal != key.horizontal ||
                      (key.horizontal ? part.x : part.y) / b != (key.horizontal ? key.x : key.y) ||
                      (key.horizontal ? part.y != key.y * b : part.x != key.x * b))
                    continue;
                  parts++;
                  ASSERT_GE(side.beyond, bounds.side(part).error[0]);
                  for (const TeSide own : {TeNorth, TeEast, TeSouth, TeWest}) {
                    const TeSideKey t = TeSeamlessLayout::sideOf(level + 1, x, y, own);
                    const TeSideBounds inner = bounds.side(t);
                    ASSERT_GE(double(side.beyond) * TeSeamlessBounds::kMorphRatio, inner.beyond * (1 - 1e-7));
                    if (level + 2 == layout.depth())
                      continue;
                    const Box innerBox = boxOf(bounds, t);
                    ASSERT_TRUE(box.x0 <= innerBox.x0 && box.y0 <= innerBox.y0 && box.x1 >= innerBox.x1 &&
                                box.y1 >= innerBox.y1);
                    ASSERT_TRUE(side.beyondRange.low <= inner.beyondRange.low &&
                                side.beyondRange.high >= inner.beyondRange.high);
                  }
                }
            const bool rim = (key.horizontal ? key.y : key.x) % layout.patchesPerSide(level) == 0;
            ASSERT_EQ(parts, rim ? b : 2 * b);
          });
      });
}

// With bands of a few rows, most cells are higher than a band.
TEST(TeSeamlessBounds, StreamedRowsGiveTheSame) {
  for (const auto& [resolution, minResolution, levels] :
       std::vector<std::array<int, 3>>{{256, 2, 3}, {256, 2, 5}, {256, 4, 2}, {128, 2, 7}})
    for (const StressField field : {StressField::Rough, StressField::Cliff, StressField::Spike}) {
      SCOPED_TRACE(int(field));
      const TeSeamlessLayout layout = layoutOf(resolution, minResolution, levels);
      const TeHeightMap map = fieldOf(field, resolution);
      const BoundsPtr whole = boundsOf(layout, map);
      for (const std::size_t memory : {std::size_t(0), std::size_t(40 * 4) * std::size_t(resolution + 1)}) {
        double done = -1;
        int most = 0;
        const BoundsPtr streamed = TeSeamlessBounds::create(
                                       layout,
                                       [&](int row, int count, float* samples) {
                                         most = std::max(most, count);
                                         EXPECT_LE(row + count, resolution + 1);
                                         for (int i = 0; i < count; i++)
                                           samples = std::copy_n(map.row(row + i), resolution + 1, samples);
                                         return TeStatus();
                                       },
                                       [&](double now) {
                                         EXPECT_GE(now, done);
                                         done = now;
                                         return true;
                                       },
                                       memory)
                                       .value();
        EXPECT_EQ(done, 1);
        EXPECT_LE(most, memory ? 33 : 17);
        EXPECT_TRUE(streamed->measured().errors == whole->measured().errors);
        EXPECT_TRUE(streamed->measured().ranges == whole->measured().ranges);
      }
    }
}

TEST(TeSeamlessBounds, RefusesWhatItCannotMeasure) {
  const TeSeamlessLayout layout = layoutOf(64, 4, 3);
  const auto messageFor = [&](const TeHeightMap& map) {
    const auto bounds = TeSeamlessBounds::create(layout, map);
    return bounds ? std::string() : bounds.error().message;
  };
  EXPECT_EQ(messageFor(*TeHeightMap::create(65, 64)),
            "bounds of seamless patches: 65 x 64 samples; the layout needs 65 x 65");
  TeHeightMap map = fieldOf(StressField::Rough, 64);
  map.at(3, 64) = TeHeightMap::missing();
  map.at(64, 0) = std::numeric_limits<float>::infinity();
  EXPECT_EQ(messageFor(map), "bounds of seamless patches: 2 samples are missing or not finite");

  const auto fails = [](int row, int, float*) {
    return row > 0 ? TeStatus(TeError{"hills_6.raw: cut off"}) : TeStatus();
  };
  EXPECT_EQ(TeSeamlessBounds::create(layout, fails, {}, 0).error().message, "hills_6.raw: cut off");
  const auto zero = [](int, int count, float* samples) {
    std::fill_n(samples, count * 65, 0.0f);
    return TeStatus();
  };
  EXPECT_EQ(TeSeamlessBounds::create(
                layout, zero, [](double done) { return done < 0.5; }, 0)
                .error()
                .message,
            "bounds of seamless patches: stopped");
  EXPECT_EQ(TeSeamlessBounds::create(layoutOf(1 << 22, 2, 2), zero).error().message,
            "bounds of seamless patches: 1466015503701 patches, at most 16777216 are allowed");

  TeSeamlessBounds::Measured measured = boundsOf(layout, fieldOf(StressField::Rough, 64))->measured();
  measured.errors[1][5] = -1;
  EXPECT_FALSE(TeSeamlessBounds::create(layout, measured));
  measured.errors[1].pop_back();
  EXPECT_FALSE(TeSeamlessBounds::create(layout, measured));
}
