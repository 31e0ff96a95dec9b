#include "apps/terrane-accuracy/TeMeshCheck.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cstring>
#include <tuple>

namespace {

struct Edge {
  TeSeamlessMesh::Vertex a; ///< the one with the lesser key
  TeSeamlessMesh::Vertex b;
};

/// Equal only for the same sample at the same height, bit for bit.
auto keyOf(const TeSeamlessMesh::Vertex& vertex) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &vertex.height, sizeof bits);
  return std::make_tuple(vertex.row, vertex.column, bits);
}

auto keyOf(const Edge& edge) { return std::tuple_cat(keyOf(edge.a), keyOf(edge.b)); }

bool onRim(const Edge& edge, int cells) {
  const auto on = [&](std::int32_t a, std::int32_t b) { return a == b && (a == 0 || a == cells); };
  return on(edge.a.column, edge.b.column) || on(edge.a.row, edge.b.row);
}

bool inView(const Edge& edge, const TeMeasuredTerrain& terrain, const TeLodView& view) {
  const auto position = [&](const TeSeamlessMesh::Vertex& vertex) {
    return glm::dvec3(vertex.column * terrain.spacing, vertex.row * terrain.spacing,
                      double(vertex.height) * terrain.heightScale);
  };
  const glm::dvec3 a = position(edge.a);
  const glm::dvec3 b = position(edge.b);
  return view.meets(glm::min(a, b), glm::max(a, b));
}

} // namespace

std::int64_t teCountCracks(const std::vector<TeSeamlessMesh::Triangle>& triangles,
                           const TeMeasuredTerrain& terrain, const TeLodView& view) {
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.size());
  const auto add = [&](const TeSeamlessMesh::Vertex& a, const TeSeamlessMesh::Vertex& b) {
    edges.push_back(keyOf(a) < keyOf(b) ? Edge{a, b} : Edge{b, a});
  };
  for (const TeSeamlessMesh::Triangle& triangle : triangles) {
    add(triangle.a, triangle.b);
    add(triangle.b, triangle.c);
    add(triangle.c, triangle.a);
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return keyOf(a) < keyOf(b); });
  std::int64_t cracks = 0;
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i + 1;
    while (end < edges.size() && keyOf(edges[end]) == keyOf(edges[i]))
      end++;
    const std::size_t expected = onRim(edges[i], terrain.cells()) ? 1 : 2;
    if (end - i != expected && inView(edges[i], terrain, view))
      cracks++;
    i = end;
  }
  return cracks;
}
