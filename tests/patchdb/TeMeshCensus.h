#pragma once

#include "patchdb/TePatchDatabase.h"

#include <array>
#include <map>
#include <tuple>
#include <vector>

/// Gathers meshes of one surface and counts what they share: vertices by their exact world position,
/// triangles by edge.
class TeMeshCensus {
public:
  struct Triangle {
    std::array<glm::dvec3, 3> corners;
    double areaInPlan() const; ///< signed, positive if counter-clockwise from above
  };

  /// False if a vertex was there before with another height or normal.
  bool add(const TePatchMesh& mesh);

  const std::vector<Triangle>& triangles() const { return m_triangles; }
  /// Edges that two triangles share, running it in opposite directions.
  long edgesWithTwoTriangles() const;
  /// The edges that have one triangle only, which form the rim.
  std::vector<std::array<glm::dvec3, 2>> rim() const;
  /// Edges with more than two triangles or with two that run it the same way.
  long brokenEdges() const;

private:
  using Point = std::array<double, 2>;
  struct Sample {
    float height;
    glm::vec3 normal;
  };
  struct Edge {
    int forth = 0;
    int back = 0;
  };
  std::map<Point, Sample> m_samples;
  std::map<std::array<Point, 2>, Edge> m_edges;
  std::vector<Triangle> m_triangles;
};

/// The insides of a block of patches and the seams and corner squares between them, each once.
std::vector<TePatchMesh> teBlockMeshes(const TePatchDatabase& database, TePatchKey southWest, int columns,
                                       int rows);
