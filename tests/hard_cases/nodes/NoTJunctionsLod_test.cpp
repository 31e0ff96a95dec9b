#include "nodes/lod/LodTest.h"

#include <cstdio>

// Random cameras over all fields that have broken LOD methods: the whole mesh has no gap and no overlap, or
// skirts hide what there is.
LOD_TEST(HardCase, NoTJunctionsLod) {
  std::mt19937 random(4);
  std::int64_t meshes = 0, triangles = 0;
  for (int stress = 0; stress <= int(StressField::Flat); stress++)
    for (const int cells : {2, 4, 16, 64, 128}) {
      TeLodField::Placement placement;
      if (random() % 2)
        placement.spacing = std::exp(double(random() % 100) / 25 - 2);
      const TeLodFieldPtr field = lodField(stressMap(StressField(stress), cells, random), placement);
      const std::unique_ptr<TeLodMethod> method = lodMethod(name, field);
      ASSERT_TRUE(method);
      LodFrame frame(field);
      for (int camera = 0; camera < 50; camera++) {
        SCOPED_TRACE(testing::Message()
                     << "field " << stress << ", " << cells << " cells, camera " << camera);
        TeLodView view = anyView(random, *field);
        view.slack = random() % 4 ? 0 : placement.spacing;
        method->select(view, anyAccuracy(random, *method));
        frame.take(*method);
        ASSERT_EQ(frame.gaps(view), 0);
        ASSERT_EQ(frame.errors(view).overlaps, 0);
        meshes++;
        triangles += method->selection().triangles;
      }
    }
  std::printf("%s: %lld cameras, %lld triangles: no gap, no overlap\n", name.c_str(),
              static_cast<long long>(meshes), static_cast<long long>(triangles));
}
