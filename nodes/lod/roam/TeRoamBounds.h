#pragma once

#include "nodes/lod/TeLodField.h"
#include "nodes/lod/roam/TeRoamTriangle.h"

#include <cstdint>
#include <memory>
#include <vector>

/// What is known of a triangle before any view, in the unit of the samples.
struct TeRoamBound {
  /// No sample that the triangle covers deviates by more from what may be drawn in its place, whatever its
  /// neighbours are (TeRoamFan), nor from any of its descendants: never less than a child's. 0 at the deepest
  /// level.
  float error = 0;
  float low = 0; ///< of the samples that it covers, its rim included
  float high = 0;
};

/// Static data of a terrain for ROAM on a triangle quadtree: for every triangle the exact error and the range
/// of heights, and where it is asked for the document's *variance*: the largest of the three errors of the
/// middles of its edges, here never less than a child's.
///
/// The two deepest levels are not stored: the errors of triangles with edges of two cells are those of three
/// samples, seen by looking at them. Memory: 2 bytes a sample, the variance 0.7 more.
/// Immutable, thread-safe.
class TeRoamBounds {
public:
  /// Cost: some 40 ns a sample.
  static std::shared_ptr<const TeRoamBounds> create(TeLodFieldPtr field, bool withVariance);

  const TeLodField& field() const { return *m_field; }
  bool hasVariance() const { return m_hasVariance; }
  std::size_t bytes() const {
    return m_bounds.size() * sizeof(TeRoamBound) + m_variances.size() * sizeof(float);
  }

  /// `number` is the triangle's.
  TeRoamBound bound(const TeRoamTriangle& triangle, std::uint32_t number) const {
    return number < m_bounds.size() ? m_bounds[number] : smallBound(triangle);
  }
  /// Only with hasVariance().
  float variance(const TeRoamTriangle& triangle, std::uint32_t number) const {
    return number < m_variances.size() ? m_variances[number] : smallBound(triangle).error;
  }
  /// The largest of the three errors of the middles of edges, rounded up; above the deepest level.
  float middleError(const TeRoamTriangle& triangle) const;

private:
  TeRoamBounds(TeLodFieldPtr field, bool withVariance)
      : m_field(std::move(field)), m_hasVariance(withVariance) {}
  TeRoamBound smallBound(const TeRoamTriangle& triangle) const;
  void measureLevel(int level);
  void inherit(int level);

  TeLodFieldPtr m_field;
  bool m_hasVariance;
  std::vector<TeRoamBound> m_bounds; ///< by number, of all levels but the two deepest
  std::vector<float> m_variances;
};
