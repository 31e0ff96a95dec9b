#pragma once

#include "nodes/lod/TeLodMesh.h"
#include "nodes/lod/TeLodMethod.h"
#include "nodes/lod/TeLodSelection.h"
#include "nodes/lod/TeScreenError.h"
#include "nodes/lod/TeWatertight.h"
#include "nodes/seamless/SeamlessViews.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <map>
#include <memory>
#include <random>

/// A stress field somewhere.
template <class Random> TeLodFieldPtr anyField(StressField kind, int cells, Random& random) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  TeLodField::Placement placement;
  placement.corner = {uniform(-1e4, 1e4), uniform(-1e4, 1e4), uniform(-100, 100)};
  placement.spacing = uniform(0.5, 20);
  placement.heightScale = uniform(0.01, 2);
  return TeLodField::create(std::make_shared<const TeHeightMap>(stressMap(kind, cells, random)), placement)
      .value();
}

/// Any camera, perspective or not, trembling or not. `wholly`: sees everything.
template <class Random> TeLodView anyView(const TeLodField& field, bool wholly, Random& random) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const double side = field.cells() * field.spacing();
  const double relief = 0.01 * side + double(field.highest()) * field.heightScale();
  TeLodView view = viewFrom(field.placement().corner + anyEye(random, side, relief), std::exp(uniform(2, 8)));
  if (!wholly)
    lookAlong(view, {uniform(-1, 1), uniform(-1, 1), uniform(-1, 0.3)}, uniform(0.05, 1.4));
  view.perspective = random() % 8 != 0;
  if (!view.perspective)
    view.focal = uniform(0.01, 10);
  view.slack = random() % 4 ? 0 : field.spacing();
  return view;
}

/// What a mesh is worth over all samples that are in view, not by rounding alone.
inline TeScreenError::Report measured(const TeLodField& field, const TeLodMesh& mesh, const TeLodView& view) {
  TeScreenError error(field.heights(), field.placement().corner, field.spacing(), field.heightScale());
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
    error.add(mesh.vertices[mesh.indices[i]], mesh.vertices[mesh.indices[i + 1]],
              mesh.vertices[mesh.indices[i + 2]]);
  TeLodView inside = view;
  for (glm::dvec4& plane : inside.planes)
    plane.w -= 1e-6;
  return error.measure(inside);
}

/// Pixels by which rounding of heights to single precision may be wrong where a report is worst.
inline double roundingAt(const TeLodField& field, const TeLodView& view,
                         const TeScreenError::Report& report) {
  const glm::dvec3 worst = field.position(field.vertex(report.worstColumn, report.worstRow));
  const double largest = std::max(std::fabs(field.lowest()), std::fabs(field.highest()));
  return view.pixels(0x1p-22 * largest * field.heightScale(), glm::distance(view.eye, worst));
}

inline void addTo(TeWatertight& mesh, const TeLodField& field, const TeLodMesh& triangles) {
  const auto number = [&](std::uint32_t index) {
    const TeLodVertex& vertex = triangles.vertices[index];
    return std::uint32_t(vertex.row * (field.cells() + 1) + vertex.column);
  };
  for (std::size_t i = 0; i < triangles.indices.size(); i += 3)
    mesh.add(number(triangles.indices[i]), number(triangles.indices[i + 1]),
             number(triangles.indices[i + 2]));
}

inline TeLodMesh meshOf(const TeLodMethod& method) {
  TeLodMesh mesh;
  method.appendMesh(mesh);
  EXPECT_EQ(mesh.triangles(), method.selection().triangles);
  return mesh;
}

/// What a method may be asked for.
template <class Random> TeLodAccuracy anyAccuracy(Random& random) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  TeLodAccuracy accuracy;
  accuracy.pixelError = random() % 20 == 0 ? 0 : std::exp(uniform(-2, 5));
  if (random() % 4 == 0)
    accuracy.dial = std::exp(uniform(-2, 5));
  accuracy.geomorph = random() % 2;
  return accuracy;
}

/// Over all samples in view: each is drawn once, and none is off by more than the selection says, which is no
/// more than was asked for. `create` makes a method over a field.
template <class Create> void expectThatBoundsHold(Create create, std::mt19937& random) {
  int frames = 0;
  double closest = 0, ratios = 0;
  for (int kind = 0; kind <= int(StressField::Flat); kind++)
    for (const int cells : {64, 128}) {
      const TeLodFieldPtr field = anyField(StressField(kind), cells, random);
      const std::unique_ptr<TeLodMethod> method = create(field);
      for (int camera = 0; camera < 60; camera++) {
        const TeLodView view = anyView(*field, camera % 3 == 0, random);
        const TeLodAccuracy accuracy = anyAccuracy(random);
        method->select(view, accuracy);
        const TeLodSelection& selection = method->selection();
        const TeScreenError::Report report = measured(*field, meshOf(*method), view);
        SCOPED_TRACE(testing::Message()
                     << "field " << kind << " of " << cells << " cells, camera " << camera);
        ASSERT_EQ(report.uncovered, 0);
        ASSERT_EQ(report.overlaps, 0);
        ASSERT_EQ(report.foreign, 0);
        ASSERT_LE(report.worst, selection.errorBound * (1 + 1e-6) + roundingAt(*field, view, report));
        if (accuracy.dial == 0) {
          ASSERT_LE(selection.errorBound, accuracy.pixelError);
        }
        if (selection.errorBound > 0 && std::isfinite(selection.errorBound)) {
          closest = std::max(closest, report.worst / selection.errorBound);
          ratios += report.worst / selection.errorBound;
          frames++;
        }
      }
    }
  EXPECT_GT(frames, 100);
  EXPECT_GT(closest, 0.99);
  std::printf("%d frames: true error on average %.2f of the bound, at most %.4f\n", frames, ratios / frames,
              closest);
}

/// Near a terrain, with 0.1 pixels wanted: a tenth of the triangles are drawn if no more are allowed, and the
/// bound stays true. In the end only one is allowed: what is drawn then is as coarse as can be.
inline void expectThatABudgetIsKept(TeLodMethod& method) {
  const TeLodField& field = method.field();
  const double side = field.cells() * field.spacing();
  const TeLodView view = viewFrom(field.placement().corner + glm::dvec3(0.5 * side, 0.5 * side, 0.2 * side));
  TeLodAccuracy accuracy;
  accuracy.pixelError = 0.1;
  method.select(view, accuracy);
  const std::int64_t all = method.selection().triangles;
  accuracy.maxTriangles = all / 10;
  method.select(view, accuracy);
  EXPECT_LE(method.selection().triangles, all / 10);
  EXPECT_GT(method.selection().coarsening, 1);
  EXPECT_LE(method.selection().errorBound, 0.1 * method.selection().coarsening);
  accuracy.maxTriangles = 1;
  method.select(view, accuracy);
}

/// The same key, the same triangles, whatever else is chosen; and two methods choose alike.
inline void expectThatKeysStandForTriangles(TeLodMethod& method, TeLodMethod& again, std::mt19937& random) {
  std::map<std::uint64_t, TeLodMesh> known;
  int met = 0;
  for (int camera = 0; camera < 100; camera++) {
    const TeLodView view = anyView(method.field(), false, random);
    const TeLodAccuracy accuracy = anyAccuracy(random);
    method.select(view, accuracy);
    again.select(view, accuracy);
    ASSERT_EQ(method.selection().parts.size(), again.selection().parts.size());
    for (std::size_t i = 0; i < method.selection().parts.size(); i++) {
      const TeLodPart& part = method.selection().parts[i];
      ASSERT_EQ(part.key, again.selection().parts[i].key);
      TeLodMesh mesh;
      method.appendPart(i, mesh);
      ASSERT_EQ(mesh.triangles(), part.triangles);
      const auto [found, isNew] = known.try_emplace(part.key, mesh);
      met += !isNew;
      const TeLodMesh& before = found->second;
      ASSERT_EQ(before.indices, mesh.indices);
      ASSERT_EQ(before.skirts, mesh.skirts);
      ASSERT_EQ(before.vertices.size(), mesh.vertices.size());
      ASSERT_EQ(std::memcmp(before.vertices.data(), mesh.vertices.data(),
                            mesh.vertices.size() * sizeof(TeLodVertex)),
                0);
    }
  }
  EXPECT_GT(met, 100);
}

/// 128 cells of 8 m, for largestJump().
template <class Random> TeLodFieldPtr hillsToDescendOn(Random& random) {
  TeLodField::Placement placement;
  placement.spacing = 8;
  return TeLodField::create(std::make_shared<const TeHeightMap>(stressMap(StressField::Rough, 128, random)),
                            placement)
      .value();
}

/// Descending on it, with 3 pixels wanted: the largest number of pixels by which a vertex moves from one
/// frame to the next. Vertices on every `apart`-th row or column are left out (1: none), where parts have
/// their own.
inline double largestJump(TeLodMethod& method, bool geomorph, int apart) {
  const TeLodField& field = method.field();
  const int cells = field.cells();
  double jump = 0;
  std::vector<float> before;
  for (int frame = 0; frame < 300; frame++) {
    const TeLodView view = viewFrom({500, 400, 8000 - 25.0 * frame});
    TeLodAccuracy accuracy;
    accuracy.pixelError = 3;
    accuracy.geomorph = geomorph;
    method.select(view, accuracy);
    EXPECT_LE(method.selection().errorBound, 3);
    std::vector<float> now(std::size_t(cells + 1) * std::size_t(cells + 1), NAN);
    const TeLodMesh mesh = meshOf(method);
    for (const std::uint32_t index : mesh.indices) {
      const TeLodVertex& vertex = mesh.vertices[index];
      if (apart == 1 || (vertex.column % apart != 0 && vertex.row % apart != 0))
        now[std::size_t(vertex.row * (cells + 1) + vertex.column)] = vertex.height;
    }
    for (std::size_t i = 0; i < before.size(); i++) {
      if (std::isnan(before[i]) || std::isnan(now[i]))
        continue;
      const glm::dvec3 at = field.position(int(i) % (cells + 1), int(i) / (cells + 1), double(now[i]));
      jump = std::max(
          jump, view.pixels(std::fabs(double(now[i]) - double(before[i])), glm::distance(view.eye, at)));
    }
    before = std::move(now);
  }
  return jump;
}
