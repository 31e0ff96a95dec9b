#include "nodes/lod/TeTriangleDeviation.h"
#include "nodes/lod/geomipmap/TeGeoMipErrors.h"
#include "tests/nodes/lod/lodTrials.h"

namespace {

float worstOf(const TeLodField& field, int x0, int y0,
              const std::vector<TeGeoMipPatterns::Triangle>& triangles) {
  float worst = 0;
  for (const auto& [a, b, c] : triangles)
    worst = std::max(worst,
                     teTriangleDeviation(field.heights(), field.vertex(x0 + a.x, y0 + a.y),
                                         field.vertex(x0 + b.x, y0 + b.y), field.vertex(x0 + c.x, y0 + c.y)));
  return worst;
}

} // namespace

// Against one triangle at a time; patches that do not fill a group of eight, too.
TEST(TeGeoMipErrors, areThoseOfTheTriangles) {
  std::mt19937 random(3);
  for (const int patchCells : {2, 8, 16}) {
    const int cells = 64;
    const TeGeoMipPatterns patterns(patchCells);
    const TeLodFieldPtr field = anyField(StressField::Rough, cells, random);
    const TeGeoMipErrors errors(*field, patterns);
    ASSERT_EQ(errors.patches(), cells / patchCells);
    for (int y = 0; y < errors.patches(); y += 3)
      for (int x = 0; x < errors.patches(); x++) {
        const int x0 = x * patchCells, y0 = y * patchCells;
        const TeGeoMipErrors::Patch patch = errors.patch(x, y);
        float regular = 0;
        for (int level = 0; level < patterns.levels(); level++) {
          regular = std::max(regular, worstOf(*field, x0, y0, patterns.regular(level)));
          ASSERT_FLOAT_EQ(patch.regular(level), regular) << x << " " << y << " level " << level;
          ASSERT_LE(patch.midpoint(level), patch.regular(level) * 1.000001f);
          for (int side = 0; side < 4; side++) {
            float stitched = 0;
            for (int border = level + 1; border < patterns.levels(); border++) {
              std::vector<TeGeoMipPatterns::Triangle> strip =
                  patterns.stitched(level, TeGeoMipSide(side), border);
              strip.push_back(patterns.half(level, TeGeoMipSide((side + 3) % 4), true));
              strip.push_back(patterns.half(level, TeGeoMipSide((side + 1) % 4), false));
              stitched = std::max(stitched, worstOf(*field, x0, y0, strip));
              ASSERT_FLOAT_EQ(patch.stitched(level, TeGeoMipSide(side), border), stitched)
                  << x << " " << y << " level " << level << " side " << side << " border " << border;
            }
          }
        }
        const TeMapStatistics statistics =
            field->heights().statistics({x0, y0, patchCells + 1, patchCells + 1}).value();
        ASSERT_EQ(errors.range(x, y).low, statistics.minimum);
        ASSERT_EQ(errors.range(x, y).high, statistics.maximum);
      }
  }
}

TEST(TeGeoMipErrors, noneOnAPlane) {
  TeHeightMap map = TeHeightMap::create(33, 33).value();
  for (int y = 0; y < 33; y++)
    for (int x = 0; x < 33; x++)
      map.at(x, y) = float(3 * x - 2 * y);
  const auto field = TeLodField::create(std::make_shared<const TeHeightMap>(std::move(map)), {}).value();
  const TeGeoMipErrors errors(*field, TeGeoMipPatterns(16));
  for (int side = 0; side < 4; side++)
    EXPECT_EQ(errors.patch(1, 0).stitched(0, TeGeoMipSide(side), 4), 0);
  EXPECT_EQ(errors.patch(0, 1).regular(4), 0);
  EXPECT_EQ(errors.patch(0, 1).midpoint(4), 0);
}
