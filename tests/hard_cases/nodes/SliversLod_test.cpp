#include "nodes/lod/LodTest.h"

#include <cstdio>

// No triangle without area or seen from below; where everything is in view their areas sum to the square.
LOD_TEST(HardCase, SliversLod) {
  std::mt19937 random(7);
  std::int64_t triangles = 0, whole = 0;
  for (int stress = 0; stress <= int(StressField::Flat); stress++)
    for (const int cells : {8, 64}) {
      const TeLodFieldPtr field = lodField(stressMap(StressField(stress), cells, random));
      const std::unique_ptr<TeLodMethod> method = lodMethod(name, field);
      ASSERT_TRUE(method);
      LodFrame frame(field);
      for (int camera = 0; camera < 60; camera++) {
        SCOPED_TRACE(testing::Message()
                     << "field " << stress << ", " << cells << " cells, camera " << camera);
        const TeLodView view = anyView(random, *field);
        method->select(view, anyAccuracy(random, *method));
        frame.take(*method);
        ASSERT_EQ(frame.slivers(), 0);
        if (view.planeCount == 0) {
          ASSERT_EQ(frame.doubleArea(), 2 * std::int64_t(cells) * cells);
          whole++;
        } else {
          ASSERT_LE(frame.doubleArea(), 2 * std::int64_t(cells) * cells);
        }
        triangles += method->selection().triangles;
      }
    }
  EXPECT_GT(whole, 100);
  std::printf("%s: %lld triangles, none inverted or without area; %lld meshes cover the square\n",
              name.c_str(), static_cast<long long>(triangles), static_cast<long long>(whole));
}
