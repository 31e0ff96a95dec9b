#include "patchdb/TeMeshCensus.h"
#include "patchdb/TeTestWorlds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

// No inverted triangle and none without area, near and far; the areas sum to the whole.
TEST(HardCase, Slivers) {
  double smallest = 1;
  double worstSum = 0;
  long triangles = 0;
  for (int samples : {5, 9, 33, 129})
    for (double spacing : {1.0, 0.1, 27.3, 1e-6, 1e6})
      for (std::int64_t place : {std::int64_t(-1), std::int64_t(1) << 20}) {
        auto database = teTestDatabase(std::make_shared<TeHashSource>(1, 9000.0f), samples, spacing);
        for (int y = 0; y < 2; ++y)
          for (int x = 0; x < 2; ++x)
            ASSERT_TRUE(database->build({place + x, place + y, 0}));
        TeMeshCensus census;
        for (const TePatchMesh& mesh : teBlockMeshes(*database, {place, place, 0}, 2, 2))
          ASSERT_TRUE(census.add(mesh));
        double sum = 0;
        for (const TeMeshCensus::Triangle& triangle : census.triangles()) {
          const double area = triangle.areaInPlan() / (0.5 * spacing * spacing);
          ASSERT_GT(area, 0.99);
          smallest = std::min(smallest, area);
          sum += area / 2;
        }
        const double whole = std::pow(2.0 * database->lattice().cells() - 2, 2);
        worstSum = std::max(worstSum, std::fabs(sum / whole - 1));
        triangles += long(census.triangles().size());
      }
  EXPECT_LT(worstSum, 1e-5);
  std::printf("Slivers: %ld triangles, smallest %.6f of its area, sums off by at most %.1e of the whole\n",
              triangles, smallest, worstSum);
}
