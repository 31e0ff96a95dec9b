#pragma once

#include "patchdb/TePatchMesh.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

/// What of a vertex does not depend on the anchor, as OpenGL gets it. 16 bits of a normal's component are
/// within 2e-5 of it: far below a step of an 8-bit colour.
struct TeVertexAttributes {
  std::int16_t normal[3]; ///< 32767 = 1
  std::int16_t unused;
  std::uint8_t colour[4]; ///< red, green, blue, alpha
};

/// A position of a mesh relative to an anchor. Origin + position is the same double in all meshes that share
/// the vertex, and so is all that follows.
inline glm::vec3 teVertexPosition(const TePatchMesh& mesh, const glm::vec3& position, glm::dvec2 anchor) {
  return {float(mesh.origin.x + position.x - anchor.x), float(mesh.origin.y + position.y - anchor.y),
          position.z};
}

/// teVertexPosition() of all vertices.
std::vector<glm::vec3> teMeshPositions(const TePatchMesh& mesh, glm::dvec2 anchor);
/// `colours`: packed as Coin does (0xRRGGBBAA), one a vertex; none: all white.
std::vector<TeVertexAttributes> teMeshAttributes(const TePatchMesh& mesh,
                                                 const std::vector<std::uint32_t>& colours);

std::int64_t teTriangleCount(const TePatchMesh& mesh);
/// True if no cell is left out: meshes of the same columns and rows then have the same triangles.
bool teIsWholeGrid(const TePatchMesh& mesh);

/// Calls use(a, b, c) with the three vertices of every triangle, counter-clockwise seen from above.
template <class Use> void teForEachTriangle(const TePatchMesh& mesh, Use&& use) {
  std::size_t begin = 0;
  for (std::size_t i = 0; i < mesh.strips.size(); i++) {
    const std::int32_t vertex = mesh.strips[i];
    if (vertex < 0) {
      begin = i + 1;
    } else if (i >= begin + 2) {
      const bool isEven = (i - begin) % 2 == 0;
      const std::int32_t first = mesh.strips[isEven ? i - 2 : i - 1];
      const std::int32_t second = mesh.strips[isEven ? i - 1 : i - 2];
      use(std::size_t(first), std::size_t(second), std::size_t(vertex));
    }
  }
}
