#include "nodes/lod/roam/RoamWorld.h"

// Any camera over any terrain, one after the other: what is drawn, and what is left out around it, has no
// crack.
TEST(HardCase, NoTJunctionsRoam) {
  std::mt19937 random(42);
  std::int64_t meshes = 0, triangles = 0, changes = 0;
  for (int stress = 0; stress <= int(StressField::Flat); stress++) {
    const TeLodFieldPtr field = stressTerrain(StressField(stress), 64, random);
    const std::unique_ptr<TeRoamLod> lod = TeRoamLod::create(field);
    TeWatertight mesh(field->cells());
    for (int camera = 0; camera < 300; camera++) {
      TeLodAccuracy accuracy;
      accuracy.pixelError = random() % 40 == 0 ? 0 : std::exp(double(random() % 100) / 15 - 2);
      if (random() % 3 == 0)
        accuracy.dial = 2 + double(random() % 3000);
      TeAllowance slice = TeAllowance::units(std::int64_t(random() % 500)), all = TeAllowance::unlimited();
      lod->select(anyView(*field, random), accuracy, random() % 3 == 0 ? slice : all);
      mesh.clear();
      addAllLeaves(lod->mesh(), mesh);
      ASSERT_EQ(mesh.cracks(), 0) << "field " << stress << " camera " << camera;
      ASSERT_EQ(mesh.slivers(), 0);
      ASSERT_TRUE(mesh.coversSquare());
      meshes++;
      triangles += lod->selection().triangles;
      changes += lod->selection().splits + lod->selection().merges;
    }
  }
  std::printf("%lld cameras, %lld triangles, %lld splits and merges: every edge inside is shared by two\n",
              static_cast<long long>(meshes), static_cast<long long>(triangles),
              static_cast<long long>(changes));
  EXPECT_GE(meshes, 1000);
}
