#pragma once

#include "generators/TeHeightMap.h"
#include "nodes/lod/TeLodMesh.h"

#include <glm/vec3.hpp>

#include <memory>

/// The terrain that LOD methods are built over: a square of (2^n + 1)² samples, n from 1 to 14, none missing,
/// and where it lies. Sample (column, row) of height h lies at corner + (column·spacing, row·spacing,
/// h·heightScale); metres.
///
/// The surface that they approximate splits each cell along its SW-NE diagonal. Immutable; thread-safe.
class TeLodField {
public:
  static constexpr int kMinCells = 2;
  static constexpr int kMaxCells = 16384; ///< a side

  struct Placement {
    glm::dvec3 corner{0};
    double spacing = 1;     ///< more than 0
    double heightScale = 1; ///< not negative: metres of a unit of the samples
  };

  /// Error: a map of another size, a missing or infinite sample (the message says where), a placement that is
  /// not finite or out of range.
  static TeResult<std::shared_ptr<const TeLodField>> create(std::shared_ptr<const TeHeightMap> heights,
                                                            const Placement& placement);

  const TeHeightMap& heights() const { return *m_heights; }
  const std::shared_ptr<const TeHeightMap>& sharedHeights() const { return m_heights; }
  int cells() const { return m_heights->width() - 1; }
  int cellsLog() const { return m_cellsLog; }
  const Placement& placement() const { return m_placement; }
  double spacing() const { return m_placement.spacing; }
  double heightScale() const { return m_placement.heightScale; }
  float lowest() const { return m_lowest; } ///< of all samples
  float highest() const { return m_highest; }

  float height(int column, int row) const { return m_heights->at(column, row); }
  TeLodVertex vertex(int column, int row) const { return {column, row, m_heights->at(column, row)}; }
  glm::dvec3 position(double column, double row, double height) const {
    return m_placement.corner + glm::dvec3(column * m_placement.spacing, row * m_placement.spacing,
                                           height * m_placement.heightScale);
  }
  glm::dvec3 position(const TeLodVertex& vertex) const {
    return position(vertex.column, vertex.row, double(vertex.height));
  }

private:
  TeLodField(std::shared_ptr<const TeHeightMap> heights, const Placement& placement);

  std::shared_ptr<const TeHeightMap> m_heights;
  Placement m_placement;
  int m_cellsLog = 0;
  float m_lowest = 0;
  float m_highest = 0;
};

using TeLodFieldPtr = std::shared_ptr<const TeLodField>;
