#include "nodes/lod/quadtree/TeQuadtreeLod.h"

#include "nodes/lod/lodTrials.h"

namespace {

std::unique_ptr<TeLodMethod> create(TeLodFieldPtr field) {
  return TeQuadtreeLod::create(std::move(field)).value();
}

struct Terrain {
  TeLodFieldPtr field;
  std::unique_ptr<TeLodMethod> method;

  explicit Terrain(TeHeightMap map) {
    field = TeLodField::create(std::make_shared<const TeHeightMap>(std::move(map)), {{}, 10, 1}).value();
    method = create(field);
  }
};

} // namespace

TEST(TeQuadtreeLod, FitsWithoutCracksFromAnywhere) {
  std::mt19937 random(3);
  TeWatertight watertight(64);
  for (int kind = 0; kind <= int(StressField::Flat); kind++) {
    const TeLodFieldPtr field = anyField(StressField(kind), 64, random);
    const std::unique_ptr<TeLodMethod> method = create(field);
    for (int camera = 0; camera < 170; camera++) {
      method->select(anyView(*field, true, random), anyAccuracy(random));
      watertight.clear();
      addTo(watertight, *field, meshOf(*method));
      ASSERT_EQ(watertight.cracks(), 0);
      ASSERT_EQ(watertight.slivers(), 0);
      ASSERT_TRUE(watertight.coversSquare());
    }
  }
}

TEST(TeQuadtreeLod, ErrorBoundHolds) {
  std::mt19937 random(20);
  expectThatBoundsHold(create, random);
}

TEST(TeQuadtreeLod, IsExactAtNoError) {
  std::mt19937 random(5);
  for (int kind = 0; kind <= int(StressField::Flat); kind++) {
    const TeLodFieldPtr field = anyField(StressField(kind), 64, random);
    const std::unique_ptr<TeLodMethod> method = create(field);
    for (int camera = 0; camera < 20; camera++) {
      const TeLodView view = anyView(*field, camera % 2 == 0, random);
      TeLodAccuracy accuracy;
      accuracy.pixelError = 0;
      accuracy.geomorph = camera % 4 > 1;
      method->select(view, accuracy);
      const TeScreenError::Report report = measured(*field, meshOf(*method), view);
      ASSERT_EQ(report.uncovered, 0);
      ASSERT_LE(report.worst, roundingAt(*field, view, report));
      ASSERT_EQ(method->selection().errorBound, 0);
    }
  }
}

TEST(TeQuadtreeLod, KeysStandForTriangles) {
  std::mt19937 random(7);
  Terrain terrain(stressMap(StressField::Rough, 128, random));
  TeLodAccuracy accuracy;
  accuracy.pixelError = 3;
  std::map<std::uint64_t, TeLodMesh> known;
  int parts = 0, met = 0;
  for (int frame = 0; frame < 200; frame++) {
    accuracy.geomorph = frame / 20 % 4 == 3;
    TeLodView view = viewFrom({300 + 2.0 * (frame % 50), 400.0 + frame, 60});
    if (frame % 40 > 30)
      lookAlong(view, {1, 0.1 * (frame % 10), -0.3}, 0.6);
    terrain.method->select(view, accuracy);
    for (std::size_t i = 0; i < terrain.method->selection().parts.size(); i++) {
      const TeLodPart& part = terrain.method->selection().parts[i];
      TeLodMesh mesh;
      terrain.method->appendPart(i, mesh);
      ASSERT_EQ(mesh.triangles(), part.triangles);
      const auto [found, isNew] = known.try_emplace(part.key, mesh);
      parts++;
      met += !isNew;
      ASSERT_EQ(found->second.indices, mesh.indices);
      ASSERT_EQ(found->second.vertices.size(), mesh.vertices.size());
      ASSERT_EQ(std::memcmp(found->second.vertices.data(), mesh.vertices.data(),
                            mesh.vertices.size() * sizeof(TeLodVertex)),
                0);
    }
  }
  std::printf("%d parts drawn, %d of them as they were\n", parts, met);
  EXPECT_GT(met, parts / 2); // most are far away
}

TEST(TeQuadtreeLod, StillCameraChangesNothing) {
  std::mt19937 random(8);
  Terrain terrain(stressMap(StressField::Rough, 128, random));
  std::vector<TeLodPart> before;
  for (int frame = 0; frame < 4; frame++) {
    terrain.method->select(viewFrom({300, 400, 60}), TeLodAccuracy());
    const std::vector<TeLodPart>& parts = terrain.method->selection().parts;
    ASSERT_GT(parts.size(), 10u);
    for (std::size_t i = 0; i < before.size(); i++)
      ASSERT_EQ(parts[i].key, before[i].key);
    before = parts;
  }
}

TEST(TeQuadtreeLod, UsesItsBudgetWithoutOscillating) {
  std::mt19937 random(8);
  Terrain terrain(stressMap(StressField::Rough, 256, random));
  TeLodAccuracy accuracy;
  accuracy.pixelError = 0.01;
  accuracy.maxTriangles = 10000;
  double coarsening = 0;
  int switches = 0, frames = 0;
  for (const bool usesDial : {false, true}) {
    accuracy.dial = usesDial ? 60000 : 0;
    for (int frame = 0; frame < 100; frame++) {
      terrain.method->select(viewFrom({300.0 + 2 * frame, 400.0 + frame, 160}), accuracy);
      const TeLodSelection& selection = terrain.method->selection();
      ASSERT_LE(selection.triangles, 10000);
      ASSERT_GE(selection.triangles, 9500);
      ASSERT_GT(selection.coarsening, 1);
      ASSERT_GT(selection.errorBound, 0.01);
      switches += selection.coarsening != coarsening;
      coarsening = selection.coarsening;
      frames++;
    }
  }
  EXPECT_LT(switches, frames / 5);
  accuracy.dial = 0;
  accuracy.pixelError = 1000;
  terrain.method->select(viewFrom({300, 400, 160}), accuracy);
  EXPECT_EQ(terrain.method->selection().coarsening, 1);
  accuracy.pixelError = 0;
  accuracy.maxTriangles = 1;
  terrain.method->select(viewFrom({300, 400, 160}), accuracy);
  EXPECT_EQ(terrain.method->selection().triangles, 4); // there is no less
}

TEST(TeQuadtreeLod, TakesSixteenBytesASampleAndItsMesh) {
  std::mt19937 random(9);
  Terrain terrain(stressMap(StressField::Rough, 256, random));
  EXPECT_LT(terrain.method->bytesPerSample(), 16.2);
  terrain.method->select(viewFrom({300, 400, 60}), TeLodAccuracy());
  EXPECT_GT(terrain.method->bytesPerSample(), 17);
}
