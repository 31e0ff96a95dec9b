#include "nodes/terrain/TeMeshVertices.h"

#include <cmath>

namespace {

std::int16_t packed(float component) { return std::int16_t(std::lround(component * 32767)); }

} // namespace

std::vector<glm::vec3> teMeshPositions(const TePatchMesh& mesh, glm::dvec2 anchor) {
  std::vector<glm::vec3> positions(mesh.positions.size());
  for (std::size_t i = 0; i < positions.size(); i++)
    positions[i] = teVertexPosition(mesh, mesh.positions[i], anchor);
  return positions;
}

std::vector<TeVertexAttributes> teMeshAttributes(const TePatchMesh& mesh,
                                                 const std::vector<std::uint32_t>& colours) {
  std::vector<TeVertexAttributes> attributes(mesh.positions.size());
  for (std::size_t i = 0; i < attributes.size(); i++) {
    TeVertexAttributes& vertex = attributes[i];
    const glm::vec3& normal = mesh.normals[i];
    vertex.normal[0] = packed(normal.x);
    vertex.normal[1] = packed(normal.y);
    vertex.normal[2] = packed(normal.z);
    vertex.unused = 0;
    const std::uint32_t colour = colours.empty() ? 0xFFFFFFFF : colours[i];
    for (int channel = 0; channel < 4; channel++)
      vertex.colour[channel] = std::uint8_t(colour >> (24 - 8 * channel));
  }
  return attributes;
}

std::int64_t teTriangleCount(const TePatchMesh& mesh) {
  std::int64_t triangles = 0;
  std::int64_t vertices = 0; // of the strip
  for (const std::int32_t vertex : mesh.strips) {
    vertices = vertex < 0 ? 0 : vertices + 1;
    triangles += vertices > 2;
  }
  return triangles;
}

bool teIsWholeGrid(const TePatchMesh& mesh) {
  return mesh.columns > 1 && mesh.rows > 1 &&
         teTriangleCount(mesh) == 2 * std::int64_t(mesh.columns - 1) * (mesh.rows - 1);
}
