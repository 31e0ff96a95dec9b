#pragma once

#include "nodes/lod/order/gridOf.h"
#include "nodes/lod/rtin/TeRtinLod.h"
#include "nodes/seamless/SeamlessViews.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <vector>

/// Triangles of many sizes: hills by right triangles, as far as they are worth it.
inline TeLodMesh irregularMesh(int cells, double metres) {
  std::mt19937 random(1);
  const auto field =
      TeLodField::create(std::make_shared<const TeHeightMap>(stressMap(StressField::Rough, cells, random)),
                         {})
          .value();
  TeRtinLod method(field, TeRtinError::Exact);
  TeLodAccuracy accuracy;
  accuracy.dial = metres;
  method.select(TeLodView(), accuracy);
  TeLodMesh mesh;
  method.appendMesh(mesh);
  return mesh;
}

/// Triangles as a sorted list, each from its lowest corner on: what they are, whatever their order.
inline std::vector<std::array<std::uint32_t, 3>> sortedTriangles(const std::vector<std::uint32_t>& indices) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    std::array<std::uint32_t, 3> corners{indices[i], indices[i + 1], indices[i + 2]};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    triangles.push_back(corners);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}
