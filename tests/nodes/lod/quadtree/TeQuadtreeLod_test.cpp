#include "nodes/lod/quadtree/TeQuadtreeLod.h"

#include "nodes/lod/TeScreenError.h"
#include "nodes/lod/TeWatertight.h"
#include "nodes/seamless/SeamlessViews.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace {

constexpr double kRounding = 1 + 1e-6;

struct Terrain {
  TeLodFieldPtr field;
  std::unique_ptr<TeLodMethod> method;

  Terrain(TeHeightMap map, const TeLodField::Placement& placement) {
    field = TeLodField::create(std::make_shared<const TeHeightMap>(std::move(map)), placement).value();
    method = TeQuadtreeLod::create(field).value();
  }
  const TeQuadtreeLod& quadtree() const { return static_cast<const TeQuadtreeLod&>(*method); }
};

TeLodField::Placement anyPlacement(std::mt19937& random) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  TeLodField::Placement placement;
  placement.corner = {uniform(-1e4, 1e4), uniform(-1e4, 1e4), uniform(-100, 100)};
  placement.spacing = uniform(0.5, 20);
  placement.heightScale = uniform(0.01, 2);
  return placement;
}

TeLodView anyView(std::mt19937& random, const TeLodField& field) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const double side = field.cells() * field.spacing();
  TeLodView view = viewFrom(field.placement().corner + anyEye(random, side, 0.3 * side), uniform(100, 3000));
  if (random() % 3 != 0)
    lookAlong(view, {uniform(-1, 1), uniform(-1, 1), uniform(-1, 0.3)}, uniform(0.05, 1.4));
  view.perspective = random() % 8 != 0;
  view.slack = random() % 4 == 0 ? uniform(0, 3) : 0;
  return view;
}

TeScreenError::Report measured(const TeLodMethod& method, const TeLodView& view, TeScreenError& error) {
  TeLodMesh mesh;
  method.appendMesh(mesh);
  EXPECT_EQ(mesh.triangles(), method.selection().triangles);
  error.clear();
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
    error.add(mesh.vertices[mesh.indices[i]], mesh.vertices[mesh.indices[i + 1]],
              mesh.vertices[mesh.indices[i + 2]]);
  return error.measure(view);
}

TeScreenError screenError(const TeLodField& field) {
  return {field.heights(), field.placement().corner, field.spacing(), field.heightScale()};
}

} // namespace

TEST(TeQuadtreeLod, FitsWithoutCracksFromAnywhere) {
  std::mt19937 random(3);
  const int cells = 64;
  TeWatertight watertight(cells);
  for (int kind = 0; kind <= int(StressField::Flat); kind++) {
    Terrain terrain(stressMap(StressField(kind), cells, random), anyPlacement(random));
    for (int trial = 0; trial < 170; trial++) {
      TeLodView view = anyView(random, *terrain.field);
      view.planeCount = 0;
      TeLodAccuracy accuracy;
      accuracy.pixelError = std::exp(std::uniform_real_distribution<double>(-3, 5)(random));
      accuracy.dial = random() % 3 == 0 ? std::exp(std::uniform_real_distribution<double>(0, 8)(random)) : 0;
      accuracy.geomorph = random() % 4 == 0;
      terrain.method->select(view, accuracy);
      TeLodMesh mesh;
      terrain.method->appendMesh(mesh);
      watertight.clear();
      for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto number = [&](std::size_t corner) {
          const TeLodVertex& vertex = mesh.vertices[mesh.indices[i + corner]];
          return std::uint32_t(vertex.row * (cells + 1) + vertex.column);
        };
        watertight.add(number(0), number(1), number(2));
      }
      ASSERT_EQ(watertight.cracks(), 0);
      ASSERT_EQ(watertight.slivers(), 0);
      ASSERT_TRUE(watertight.coversSquare());
    }
  }
}

TEST(TeQuadtreeLod, ErrorBoundHolds) {
  std::mt19937 random(20);
  double closest = 0, ratios = 0;
  int frames = 0;
  for (int kind = 0; kind <= int(StressField::Flat); kind++) {
    Terrain terrain(stressMap(StressField(kind), 128, random), anyPlacement(random));
    TeScreenError error = screenError(*terrain.field);
    for (int trial = 0; trial < 60; trial++) {
      const TeLodView view = anyView(random, *terrain.field);
      TeLodAccuracy accuracy;
      accuracy.pixelError = std::exp(std::uniform_real_distribution<double>(-3, 5)(random));
      accuracy.dial = random() % 3 == 0 ? std::exp(std::uniform_real_distribution<double>(0, 8)(random)) : 0;
      accuracy.geomorph = random() % 3 == 0;
      terrain.method->select(view, accuracy);
      const TeScreenError::Report report = measured(*terrain.method, view, error);
      const double bound = terrain.method->selection().errorBound;
      ASSERT_EQ(report.uncovered, 0);
      ASSERT_EQ(report.overlaps, 0);
      ASSERT_LE(report.worst, bound * kRounding + 1e-6);
      if (!(accuracy.dial > 0)) {
        ASSERT_LE(bound, accuracy.pixelError * kRounding);
      }
      if (report.samples > 0 && bound > 0 && std::isfinite(bound)) {
        closest = std::max(closest, report.worst / bound);
        ratios += report.worst / bound;
        frames++;
      }
    }
  }
  std::printf("[   INFO   ] %d frames: true worst / bound %.3f on average, %.3f at most\n", frames,
              ratios / frames, closest);
  EXPECT_GT(closest, 0.8); // it is no bound from nowhere
}

TEST(TeQuadtreeLod, IsExactAtNoError) {
  std::mt19937 random(5);
  for (int kind = 0; kind <= int(StressField::Flat); kind++) {
    Terrain terrain(stressMap(StressField(kind), 64, random), anyPlacement(random));
    TeScreenError error = screenError(*terrain.field);
    for (int trial = 0; trial < 20; trial++) {
      const TeLodView view = anyView(random, *terrain.field);
      TeLodAccuracy accuracy;
      accuracy.pixelError = 0;
      accuracy.geomorph = trial % 2 == 1;
      terrain.method->select(view, accuracy);
      const TeScreenError::Report report = measured(*terrain.method, view, error);
      ASSERT_EQ(report.uncovered, 0);
      ASSERT_LE(report.worst, 1e-6);
      ASSERT_EQ(terrain.method->selection().errorBound, 0);
    }
  }
}

TEST(TeQuadtreeLod, KeyTellsWhetherTrianglesChanged) {
  std::mt19937 random(7);
  Terrain terrain(stressMap(StressField::Rough, 128, random), TeLodField::Placement{{}, 10, 1});
  TeLodAccuracy accuracy;
  accuracy.pixelError = 3;
  TeLodMesh last;
  std::uint64_t lastKey = 0;
  int same = 0;
  for (int frame = 0; frame < 200; frame++) {
    const double x = frame % 10 < 5 ? 0 : 0.2 * frame;
    terrain.method->select(viewFrom({300 + x, 400, 60}), accuracy);
    ASSERT_EQ(terrain.method->selection().parts.size(), 1u);
    const std::uint64_t key = terrain.method->selection().parts[0].key;
    TeLodMesh mesh;
    terrain.method->appendMesh(mesh);
    if (key == lastKey) {
      same++;
      ASSERT_EQ(mesh.indices, last.indices);
      ASSERT_EQ(mesh.vertices.size(), last.vertices.size());
      for (std::size_t i = 0; i < mesh.vertices.size(); i++)
        ASSERT_EQ(mesh.vertices[i].height, last.vertices[i].height);
    }
    last = mesh;
    lastKey = key;
  }
  EXPECT_GE(same, 80); // a still camera changes nothing
}

TEST(TeQuadtreeLod, UsesItsBudgetWithoutOscillating) {
  std::mt19937 random(8);
  Terrain terrain(stressMap(StressField::Rough, 256, random), TeLodField::Placement{{}, 10, 1});
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
  Terrain terrain(stressMap(StressField::Rough, 256, random), TeLodField::Placement{{}, 10, 1});
  EXPECT_LT(terrain.method->bytesPerSample(), 16.2);
  terrain.method->select(viewFrom({300, 400, 60}), TeLodAccuracy());
  EXPECT_GT(terrain.method->bytesPerSample(), 17);
}
