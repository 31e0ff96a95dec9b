#include "nodes/lod/drawing/TeLodArrays.h"

#include "patchdb/TeSurfaceNormals.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

std::int16_t packed(float component) {
  const float scaled = component * 32767;
  return std::int16_t(scaled + (scaled < 0 ? -0.5f : 0.5f));
}

std::uint8_t packedColour(float channel) {
  return std::uint8_t(std::clamp(channel, 0.0f, 1.0f) * 255.0f + 0.5f);
}

template <class Index> void append(const std::vector<std::uint32_t>& from, std::vector<Index>& to) {
  for (const std::uint32_t index : from)
    to.push_back(Index(index));
}

} // namespace

std::int64_t TeLodArrays::triangles() const {
  const std::size_t corners = shortIndices.size() + indices.size();
  return std::int64_t(corners > 0 ? corners : vertices.size()) / 3;
}

std::size_t TeLodArrays::indexBytes() const {
  return shortIndices.size() * sizeof(std::uint16_t) + indices.size() * sizeof(std::uint32_t);
}

const void* TeLodArrays::indexData() const {
  return shortIndices.empty() ? static_cast<const void*>(indices.data()) : shortIndices.data();
}

void TeLodArrayMaker::make(const TeLodMesh& mesh, TeLodArrays& arrays) const {
  arrays.vertices.clear();
  arrays.shortIndices.clear();
  arrays.indices.clear();
  for (const TeLodVertex& vertex : mesh.vertices)
    arrays.vertices.push_back(drawn(vertex));
  if (mesh.vertices.size() <= std::numeric_limits<std::uint16_t>::max()) {
    append(mesh.indices, arrays.shortIndices);
    append(mesh.skirts, arrays.shortIndices);
  } else {
    append(mesh.indices, arrays.indices);
    append(mesh.skirts, arrays.indices);
  }
}

void TeLodArrayMaker::expand(TeLodArrays& arrays) {
  std::vector<TeDrawnVertex> vertices;
  vertices.reserve(arrays.shortIndices.size() + arrays.indices.size());
  for (const std::uint16_t index : arrays.shortIndices)
    vertices.push_back(arrays.vertices[index]);
  for (const std::uint32_t index : arrays.indices)
    vertices.push_back(arrays.vertices[index]);
  arrays = {std::move(vertices), {}, {}};
}

TeDrawnVertex TeLodArrayMaker::drawn(const TeLodVertex& vertex) const {
  TeDrawnVertex result;
  const glm::dvec3 position = m_field.position(vertex) - m_anchor;
  const glm::vec3 normal = this->normal(vertex);
  const glm::vec3 colour = this->colour(vertex, normal);
  for (int axis = 0; axis < 3; axis++) {
    result.position[axis] = float(position[axis]);
    result.normal[axis] = packed(normal[axis]);
    result.colour[axis] = packedColour(colour[axis]);
  }
  result.unused = 0;
  result.colour[3] = 255;
  return result;
}

glm::vec3 TeLodArrayMaker::normal(const TeLodVertex& vertex) const {
  if (!(m_field.heightScale() > 0))
    return {0, 0, 1};
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  const int x = vertex.column, y = vertex.row, last = m_field.cells();
  return teSampleNormal(m_field.height(x, y), x > 0 ? m_field.height(x - 1, y) : kNone,
                        x < last ? m_field.height(x + 1, y) : kNone, y > 0 ? m_field.height(x, y - 1) : kNone,
                        y < last ? m_field.height(x, y + 1) : kNone,
                        m_field.spacing() / m_field.heightScale());
}

glm::vec3 TeLodArrayMaker::colour(const TeLodVertex& vertex, const glm::vec3& normal) const {
  if (!m_colours)
    return glm::vec3(1);
  const float slope = std::sqrt(normal.x * normal.x + normal.y * normal.y) / std::max(normal.z, 1e-6f);
  const float height = float(double(m_field.height(vertex.column, vertex.row)) * m_field.heightScale());
  return m_colours->colour(height, slope);
}
