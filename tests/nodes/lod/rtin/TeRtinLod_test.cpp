#include "nodes/lod/rtin/TeRtinLod.h"

#include "nodes/lod/TeLodMethods.h"
#include "nodes/lod/lodTrials.h"

#include <cstdio>

namespace {

/// The dial is in metres here.
TeLodAccuracy anyWish(std::mt19937& random) {
  TeLodAccuracy accuracy = anyAccuracy(random);
  if (accuracy.dial > 0)
    accuracy.dial = std::exp(std::uniform_real_distribution<double>(-4, 3)(random));
  return accuracy;
}

} // namespace

TEST(TeRtinLod, ItsBoundHolds) {
  std::mt19937 random(6);
  int frames = 0;
  double closest = 0, ratios = 0;
  for (int kind = 0; kind <= int(StressField::Flat); kind++)
    for (const int cells : {64, 256}) {
      const TeLodFieldPtr field = anyField(StressField(kind), cells, random);
      TeRtinLod method(field, TeRtinError::Exact);
      for (int camera = 0; camera < 20; camera++) {
        const TeLodView view = anyView(*field, camera % 3 == 0, random);
        const TeLodAccuracy accuracy = anyWish(random);
        method.select(view, accuracy);
        const TeLodSelection& selection = method.selection();
        const TeScreenError::Report report = measured(*field, meshOf(method), view);
        ASSERT_EQ(report.uncovered, 0);
        ASSERT_EQ(report.overlaps, 0);
        ASSERT_EQ(report.foreign, 0);
        ASSERT_LE(report.worst, selection.errorBound * (1 + 1e-6) + roundingAt(*field, view, report))
            << "field " << kind << " camera " << camera;
        if (accuracy.dial == 0) {
          ASSERT_LE(selection.errorBound, accuracy.pixelError);
        } else {
          ASSERT_LE(report.worstMetres, accuracy.dial * (1 + 1e-6));
        }
        if (selection.errorBound > 0 && std::isfinite(selection.errorBound)) {
          closest = std::max(closest, report.worst / selection.errorBound);
          ratios += report.worst / selection.errorBound;
          frames++;
        }
      }
    }
  EXPECT_GT(closest, 0.9);
  std::printf("%d frames: true error on average %.2f of the bound, at most %.4f\n", frames, ratios / frames,
              closest);
}

TEST(TeRtinLod, MidpointErrorsAreNoBoundAndItSaysSo) {
  std::mt19937 random(5);
  const TeLodFieldPtr field = anyField(StressField::Rough, 128, random);
  TeRtinLod method(field, TeRtinError::Midpoint);
  TeLodView view;
  view.eye = field->placement().corner - glm::dvec3(0, 0, 100);
  TeLodAccuracy accuracy;
  accuracy.dial = 0.3 * double(field->highest()) * field->heightScale();
  method.select(view, accuracy);
  EXPECT_TRUE(std::isinf(method.selection().errorBound));
  const TeScreenError::Report report = measured(*field, meshOf(method), view);
  EXPECT_EQ(report.uncovered, 0);
  std::printf("wanted %.3f m, true error %.3f m\n", accuracy.dial, report.worstMetres);
  accuracy = TeLodAccuracy();
  accuracy.pixelError = 0;
  method.select(view, accuracy);
  EXPECT_EQ(method.selection().errorBound, 0);
  EXPECT_EQ(method.selection().triangles, 2 * 128 * 128);
}

TEST(TeRtinLod, NoErrorMeansEverySample) {
  std::mt19937 random(7);
  for (const StressField kind : {StressField::Plateau, StressField::Flat}) {
    const TeLodFieldPtr field = anyField(kind, 64, random);
    TeRtinLod method(field, TeRtinError::Exact);
    TeLodAccuracy exact;
    exact.pixelError = 0;
    method.select(anyView(*field, true, random), exact);
    EXPECT_EQ(method.selection().triangles, 2 * 64 * 64);
    EXPECT_EQ(method.selection().errorBound, 0);
  }
}

TEST(TeRtinLod, TakesAnySize) {
  std::mt19937 random(8);
  for (const char* name : {"rtin", "rtin-midpoint"})
    for (int cells = 2; cells <= 256; cells *= 2) {
      const TeLodFieldPtr field = anyField(StressField::Rough, cells, random);
      const auto method = TeLodMethods::create(name, field);
      ASSERT_TRUE(method);
      EXPECT_EQ((*method)->name(), name);
      for (int camera = 0; camera < 5; camera++) {
        (*method)->select(anyView(*field, true, random), anyAccuracy(random));
        TeWatertight mesh(cells);
        addTo(mesh, *field, meshOf(**method));
        EXPECT_EQ(mesh.cracks(), 0);
        EXPECT_TRUE(mesh.coversSquare());
      }
    }
}

// A triangle at a steep place forces its neighbours, over the whole terrain, to be halved, not more.
TEST(TeRtinLod, DrawsFlatGroundWithFewTriangles) {
  std::mt19937 random(9);
  const TeLodFieldPtr field = anyField(StressField::Spike, 256, random);
  TeRtinLod method(field, TeRtinError::Exact);
  TeLodAccuracy accuracy;
  accuracy.dial = 0.01 * double(field->highest()) * field->heightScale();
  method.select(anyView(*field, true, random), accuracy);
  EXPECT_LE(method.selection().triangles, 2 + 16 * 4 * 8);
  EXPECT_GE(method.selection().triangles, 2 + 16 * 2);
}

TEST(TeRtinLod, LowersTheAccuracyForABudget) {
  std::mt19937 random(10);
  const TeLodFieldPtr field = anyField(StressField::Rough, 256, random);
  TeRtinLod method(field, TeRtinError::Exact);
  const double side = 256 * field->spacing();
  const TeLodView view = viewFrom(
      field->placement().corner +
      glm::dvec3(0.5 * side, 0.5 * side, 0.2 * side + double(field->highest()) * field->heightScale()));
  TeLodAccuracy accuracy;
  accuracy.pixelError = 0;
  method.select(view, accuracy);
  const std::int64_t all = method.selection().triangles;
  accuracy.maxTriangles = all / 10;
  method.select(view, accuracy);
  EXPECT_LE(method.selection().triangles, all / 10);
  EXPECT_GE(method.selection().triangles, all / 10 * 0.95);
  EXPECT_GT(method.selection().coarsening, 1);
  EXPECT_LE(method.selection().errorBound, method.selection().coarsening / 64);
  EXPECT_EQ(measured(*field, meshOf(method), view).uncovered, 0);
  // What keeps the budget is kept, from near by, too.
  const double coarsening = method.selection().coarsening;
  TeLodView near = view;
  near.eye.x += 1e-3 * side;
  method.select(near, accuracy);
  EXPECT_EQ(method.selection().coarsening, coarsening);
  accuracy.maxTriangles = 2 * all;
  method.select(view, accuracy);
  EXPECT_EQ(method.selection().coarsening, 1);
  EXPECT_EQ(method.selection().triangles, all);
  // As coarse as can be, if even that is too much.
  accuracy.maxTriangles = 1;
  method.select(view, accuracy);
  EXPECT_EQ(method.selection().triangles, 2);
}

TEST(TeRtinLod, KeysStandForTriangles) {
  std::mt19937 random(11);
  const TeLodFieldPtr field = anyField(StressField::Plateau, 128, random);
  TeRtinLod method(field, TeRtinError::Exact), again(field, TeRtinError::Exact);
  expectThatKeysStandForTriangles(method, again, random);
}
