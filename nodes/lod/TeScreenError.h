#pragma once

#include "generators/TeHeightMap.h"
#include "nodes/lod/TeLatticeTriangle.h"
#include "nodes/lod/TeLodMesh.h"
#include "nodes/lod/TeLodView.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

/// Measures how far triangles over a grid of samples are from the surface of all samples, as a view sees it:
/// for any LOD method whose vertices lie on samples. Nothing is estimated; every sample is looked at.
///
///     error.clear();
///     for each triangle: error.add(a, b, c);
///     report = error.measure(view);
///
/// One thread at a time. Memory: 5 bytes a sample and what measure() keeps for its quantile, 4 bytes a sample
/// in view. Cost: about 12 ns a sample and 25 ns a triangle.
class TeScreenError {
public:
  using Vertex = TeLodVertex;

  struct Report {
    std::int64_t samples = 0;   ///< in view, by their own heights; a missing sample never is
    std::int64_t uncovered = 0; ///< of those, under no triangle: they have no part in what follows
    /// Vertical deviations of the others: pixels by TeLodView::pixels() at the sample, and metres. 0 if there
    /// are no others.
    double worst = 0;
    double quantile = 0; ///< 99.9 % of the samples are not above it, and one has it
    double rms = 0;
    double worstMetres = 0;
    std::int32_t worstColumn = 0; ///< where `worst` is found
    std::int32_t worstRow = 0;

    /// Samples, in view or not, in more than one triangle but not for a common edge or corner: 0 unless
    /// triangles overlap.
    std::int64_t overlaps = 0;
    std::int64_t triangles = 0;
    std::int64_t foreign = 0; ///< triangles left out: no area, a corner off the map or of no finite height
  };

  /// Sample (column, row) of height h lies at corner + (column·spacing, row·spacing, h·heightScale), metres.
  /// `heights` must outlive this and not change.
  TeScreenError(const TeHeightMap& heights, const glm::dvec3& corner, double spacing, double heightScale);

  /// Forgets all triangles.
  void clear();
  /// A triangle, of either orientation.
  void add(const Vertex& a, const Vertex& b, const Vertex& c);
  /// Of the triangles that were added.
  Report measure(const TeLodView& view);

private:
  void addRow(int row, const TeLatticeTriangle::Span& span, double start, double slope);
  void measureRow(const TeLodView& view, int row);
  void gatherRow(int row, Report& report);
  bool isForeign(const Vertex& a, const Vertex& b, const Vertex& c) const;

  const TeHeightMap* m_heights;
  glm::dvec3 m_corner;
  double m_spacing;
  double m_heightScale;
  std::vector<float> m_deviations;     ///< by sample, in its unit; negative under no triangle
  std::vector<std::uint8_t> m_covered; ///< by sample: number of triangles, but for common edges; at most 2
  std::int64_t m_triangles = 0;
  std::int64_t m_foreign = 0;

  std::vector<double> m_squares; ///< of the row in work, by column: deviation in pixels; negative out of view
  std::vector<float> m_inView;   ///< squares of deviations in pixels
};
