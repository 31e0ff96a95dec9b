#pragma once

#include "nodes/lod/TeWatertight.h"
#include "nodes/lod/roam/TeRoamFan.h"
#include "nodes/lod/roam/TeRoamLod.h"
#include "nodes/seamless/SeamlessViews.h"

#include <gtest/gtest.h>

#include <memory>
#include <random>

/// A stress field as a terrain, samples `spacing` metres apart.
template <class Random>
TeLodFieldPtr stressTerrain(StressField field, int cells, Random& random, double spacing = 1) {
  auto map = std::make_shared<const TeHeightMap>(stressMap(field, cells, random));
  TeLodField::Placement placement;
  placement.spacing = spacing;
  return TeLodField::create(map, placement).value();
}

/// An eye and a direction of any kind; now and then without planes, orthographic, or held.
template <class Random> TeLodView anyView(const TeLodField& field, Random& random) {
  const double side = field.cells() * field.spacing();
  const double relief = std::max(1.0, double(field.highest()));
  const double focals[] = {665.1, 100, 5, 1e5};
  TeLodView view = viewFrom(anyEye(random, side, relief), focals[random() % 4]);
  if (random() % 4 != 0) {
    const auto component = [&] { return double(random() % 2001) / 1000 - 1; };
    lookAlong(view, glm::dvec3(component(), component(), component() - 1e-4),
              0.1 + double(random() % 100) / 100);
  }
  view.perspective = random() % 10 != 0;
  view.slack = random() % 4 == 0 ? field.spacing() : 0;
  return view;
}

/// All leaves, in view or not, as they are drawn.
inline void addAllLeaves(const TeRoamMesh& mesh, TeWatertight& check) {
  const TeRoamNodes& nodes = mesh.nodes();
  const int width = nodes.bounds().field().cells() + 1;
  for (std::int32_t node = 0; node < std::int32_t(nodes.size()); node++) {
    if (mesh.fan(node) == 0)
      continue;
    std::uint32_t points[6];
    for (int k = 0; k < 6; k++) {
      const TeLodVertex& place = nodes.vertices()[std::size_t(nodes.points(node).vertices[k])];
      points[k] = std::uint32_t(place.row * width + place.column);
    }
    const TeRoamFan& fan = TeRoamFan::all()[nodes.points(node).edges];
    for (int i = 0; i < fan.count; i++) {
      const TeRoamFan::Triangle& triangle = fan.triangles[std::size_t(i)];
      check.add(points[triangle[0]], points[triangle[1]], points[triangle[2]]);
    }
  }
}

/// Numbers of all triangles that are split, sorted: the mesh, whatever came before.
inline std::vector<std::uint32_t> splitTriangles(const TeRoamMesh& mesh) {
  std::vector<std::uint32_t> numbers;
  const TeRoamNodes& nodes = mesh.nodes();
  for (std::int32_t node = 0; node < std::int32_t(nodes.size()); node++)
    if (nodes.boxes().error[std::size_t(node)] >= 0 && !nodes[node].isLeaf())
      numbers.push_back(nodes[node].number);
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}
