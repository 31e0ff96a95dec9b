#pragma once

#include "nodes/lod/TeLodField.h"
#include "nodes/seamless/TeSeamlessSlopeColours.h"

#include <cstdint>
#include <vector>

/// A vertex as OpenGL gets it: 24 bytes.
struct TeDrawnVertex {
  float position[3];      ///< metres from an anchor
  std::int16_t normal[3]; ///< 32767 = 1
  std::int16_t unused;
  std::uint8_t colour[4]; ///< red, green, blue, alpha
};

/// Triangles of a part as OpenGL gets them.
struct TeLodArrays {
  std::vector<TeDrawnVertex> vertices;
  /// Three a triangle, in one of these; in none: three vertices a triangle.
  std::vector<std::uint16_t> shortIndices;
  std::vector<std::uint32_t> indices;

  std::int64_t triangles() const;
  std::size_t vertexBytes() const { return vertices.size() * sizeof(TeDrawnVertex); }
  std::size_t indexBytes() const;
  std::size_t bytes() const { return vertexBytes() + indexBytes(); }
  const void* indexData() const;
};

/// Makes them: positions relative to an anchor near the eye, so that single precision is enough; normals of
/// the surface of all samples (TeSurfaceNormals.h), whatever triangles meet there; colours by height and
/// slope, if there are any. A vertex that parts share gets the same bits in all of them.
class TeLodArrayMaker {
public:
  /// All must outlive it. `colours` may be null: white.
  TeLodArrayMaker(const TeLodField& field, const glm::dvec3& anchor, const TeSeamlessSlopeColours* colours)
      : m_field(field), m_anchor(anchor), m_colours(colours) {}

  /// Replaces the arrays. Indices have 16 bits where that is enough; the largest is never used, as it may
  /// stand for a restart of primitives.
  void make(const TeLodMesh& mesh, TeLodArrays& arrays) const;
  /// Three vertices a triangle, without indices.
  static void expand(TeLodArrays& arrays);

  glm::vec3 normal(const TeLodVertex& vertex) const;
  /// 0 .. 1 each; white without colours.
  glm::vec3 colour(const TeLodVertex& vertex, const glm::vec3& normal) const;

private:
  TeDrawnVertex drawn(const TeLodVertex& vertex) const;

  const TeLodField& m_field;
  glm::dvec3 m_anchor;
  const TeSeamlessSlopeColours* m_colours;
};
