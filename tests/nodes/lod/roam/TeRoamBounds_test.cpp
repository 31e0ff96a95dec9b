#include "nodes/lod/roam/TeRoamBounds.h"

#include "nodes/lod/TeLatticeTriangle.h"
#include "nodes/lod/TeTriangleDeviation.h"
#include "nodes/lod/roam/RoamWorld.h"
#include "nodes/lod/roam/TeRoamErrorRows.h"

namespace {

constexpr int kCells = 64;
constexpr int kLog = 6;

TeLodVertex vertexOf(const TeLodField& field, const TeRoamTriangle& triangle, int point) {
  const TeRoamTriangle::Point place =
      point < 3 ? triangle.corner(point, field.cellsLog()) : triangle.middle(point - 3, field.cellsLog());
  return field.vertex(place.column, place.row);
}

/// Largest deviation of all that may be drawn for a triangle and below it, one by one.
float worstOf(const TeLodField& field, const TeRoamTriangle& triangle) {
  if (triangle.level == field.cellsLog())
    return 0;
  float worst = 0;
  for (const TeRoamFan& fan : TeRoamFan::all())
    for (int i = 0; i < fan.count; i++) {
      const TeRoamFan::Triangle& part = fan.triangles[std::size_t(i)];
      worst = std::max(worst, teTriangleDeviation(field.heights(), vertexOf(field, triangle, part[0]),
                                                  vertexOf(field, triangle, part[1]),
                                                  vertexOf(field, triangle, part[2])));
    }
  for (int k = 0; k < 4; k++)
    worst = std::max(worst, worstOf(field, triangle.child(k)));
  return worst;
}

template <class Visit> void forEachTriangle(Visit visit) {
  for (int level = 0; level <= kLog; level++)
    for (int y = 0; y < 1 << level; y++)
      for (int x = 0; x < 1 << level; x++)
        for (const bool upper : {false, true})
          visit(TeRoamTriangle{level, x, y, upper});
}

} // namespace

TEST(TeRoamBounds, errorIsTheLargestOfAllThatMayBeDrawn) {
  std::mt19937 random(5);
  for (int field = 0; field <= int(StressField::Flat); field++) {
    const TeLodFieldPtr terrain = stressTerrain(StressField(field), kCells, random);
    const auto bounds = TeRoamBounds::create(terrain, false);
    forEachTriangle([&](const TeRoamTriangle& triangle) {
      const float error = bounds->bound(triangle, triangle.number()).error;
      const float worst = worstOf(*terrain, triangle);
      // Both are rounded up; planes may be computed in another order.
      ASSERT_NEAR(error, worst, 1e-6f * (worst + 1)) << "field " << field << " level " << triangle.level;
    });
  }
}

TEST(TeRoamBounds, rangesHoldEverySampleAndNoOther) {
  std::mt19937 random(6);
  const TeLodFieldPtr terrain = stressTerrain(StressField::Rough, kCells, random);
  const auto bounds = TeRoamBounds::create(terrain, false);
  forEachTriangle([&](const TeRoamTriangle& triangle) {
    const TeLodVertex a = vertexOf(*terrain, triangle, 0), b = vertexOf(*terrain, triangle, 1),
                      c = vertexOf(*terrain, triangle, 2);
    float low = a.height, high = a.height;
    const TeLatticeTriangle covered(a, b, c);
    for (int row = covered.firstRow(); row <= covered.lastRow(); row++)
      for (int column = covered.span(row).first; column <= covered.span(row).last; column++) {
        low = std::min(low, terrain->height(column, row));
        high = std::max(high, terrain->height(column, row));
      }
    const TeRoamBound bound = bounds->bound(triangle, triangle.number());
    ASSERT_EQ(bound.low, low);
    ASSERT_EQ(bound.high, high);
  });
}

TEST(TeRoamBounds, varianceIsOfMiddlesAndNeverLessThanAChilds) {
  std::mt19937 random(7);
  const TeLodFieldPtr terrain = stressTerrain(StressField::Rough, kCells, random);
  const auto bounds = TeRoamBounds::create(terrain, true);
  ASSERT_TRUE(bounds->hasVariance());
  int belowError = 0;
  forEachTriangle([&](const TeRoamTriangle& triangle) {
    const std::uint32_t number = triangle.number();
    const float variance = bounds->variance(triangle, number);
    ASSERT_LE(variance, bounds->bound(triangle, number).error);
    belowError += variance < bounds->bound(triangle, number).error;
    if (triangle.level == kLog)
      return;
    float wanted = bounds->middleError(triangle);
    for (int k = 0; k < 4; k++)
      wanted = std::max(wanted, bounds->variance(triangle.child(k), TeRoamTriangle::childOf(number, k)));
    ASSERT_EQ(variance, wanted);
  });
  EXPECT_GT(belowError, 0); // it is no bound
}

// Wide maps measure their rows of small squares at once, narrow ones each triangle.
TEST(TeRoamErrorRows, rowsAtOnceAreTheSameAsOneByOne) {
  std::mt19937 random(8);
  const TeHeightMap wide = stressMap(StressField::Rough, 128, random);
  TeHeightMap narrow = TeHeightMap::create(33, 33).value();
  for (int side : {4, 8}) {
    TeRoamErrorRows whole(wide, side);
    std::vector<float> lower(std::size_t(whole.squares())), upper(lower.size());
    ASSERT_GE(whole.squares(), 16);
    for (int y0 = 0; y0 < 128; y0 += 32)
      for (int x0 = 0; x0 < 128; x0 += 32) {
        ASSERT_TRUE(narrow.copy(wide, {x0, y0, 33, 33}, narrow.bounds()).ok());
        TeRoamErrorRows part(narrow, side);
        ASSERT_LT(part.squares(), 16);
        std::vector<float> partLower(std::size_t(part.squares())), partUpper(partLower.size());
        for (int row = 0; row < part.squares(); row++) {
          whole.measure(y0 / side + row, lower.data(), upper.data());
          part.measure(row, partLower.data(), partUpper.data());
          for (int x = 0; x < part.squares(); x++) {
            const auto at = std::size_t(x0 / side + x);
            EXPECT_NEAR(lower[at], partLower[std::size_t(x)], 1e-6);
            EXPECT_NEAR(upper[at], partUpper[std::size_t(x)], 1e-6);
          }
        }
      }
  }
}

TEST(TeRoamBounds, smallestTerrainsHaveBounds) {
  std::mt19937 random(9);
  for (const int cells : {2, 4, 8}) {
    const TeLodFieldPtr terrain = stressTerrain(StressField::Checkerboard, cells, random);
    const auto bounds = TeRoamBounds::create(terrain, true);
    const TeRoamTriangle base{0, 0, 0, true};
    EXPECT_EQ(bounds->bound(base, 1).error, worstOf(*terrain, base)) << cells;
    EXPECT_GT(bounds->variance(base, 1), 0) << cells;
  }
}
