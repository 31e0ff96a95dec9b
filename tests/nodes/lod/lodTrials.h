#pragma once

#include "nodes/lod/TeLodMethod.h"
#include "nodes/lod/TeScreenError.h"
#include "nodes/lod/TeWatertight.h"
#include "nodes/seamless/SeamlessViews.h"

#include <gtest/gtest.h>

#include <cmath>
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
