#include "nodes/lod/lodTrials.h"
#include "nodes/lod/rtin/TeRtinLod.h"

#include <cstdio>

// Any camera over any terrain: every edge inside is shared by two triangles, and nothing is missing.
TEST(HardCase, NoTJunctionsRtin) {
  std::mt19937 random(43);
  std::int64_t meshes = 0, triangles = 0;
  for (int kind = 0; kind <= int(StressField::Flat); kind++)
    for (const TeRtinError error : {TeRtinError::Exact, TeRtinError::Midpoint}) {
      const TeLodFieldPtr field = anyField(StressField(kind), 64, random);
      TeRtinLod method(field, error);
      TeWatertight mesh(field->cells());
      for (int camera = 0; camera < 300; camera++) {
        TeLodAccuracy accuracy;
        accuracy.pixelError = random() % 40 == 0 ? 0 : std::exp(double(random() % 100) / 15 - 2);
        if (random() % 3 == 0)
          accuracy.dial = std::exp(double(random() % 100) / 15 - 3);
        method.select(anyView(*field, true, random), accuracy);
        TeLodMesh drawn;
        method.appendMesh(drawn);
        mesh.clear();
        addTo(mesh, *field, drawn);
        ASSERT_EQ(mesh.cracks(), 0) << "field " << kind << " camera " << camera;
        ASSERT_EQ(mesh.slivers(), 0);
        ASSERT_TRUE(mesh.coversSquare());
        meshes++;
        triangles += drawn.triangles();
      }
    }
  std::printf("%lld cameras, %lld triangles: every edge inside is shared by two\n",
              static_cast<long long>(meshes), static_cast<long long>(triangles));
  EXPECT_GE(meshes, 1000);
}
