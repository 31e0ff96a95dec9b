#pragma once

#include "nodes/lod/TeLodField.h"
#include "nodes/lod/geomipmap/TeGeoMipPatterns.h"

#include <vector>

/// What each patch of a terrain deviates from its samples, at each level and beside each coarser neighbour:
/// exact over all of its samples, in their unit, rounded up. All numbers rise with the level.
///
/// Memory: 8·(L - 1)·(L + 1) + 8 bytes a patch of L levels. Cost: a pass over the samples of each level and
/// strip, eight patches at a time.
class TeGeoMipErrors {
public:
  TeGeoMipErrors(const TeLodField& field, const TeGeoMipPatterns& patterns);

  int patches() const { return m_patches; } ///< a side

  struct Range {
    float low = 0; ///< of the samples
    float high = 0;
  };
  const Range& range(int x, int y) const { return m_ranges[number(x, y)]; }

  /// The errors of one patch.
  class Patch {
  public:
    Patch(const TeGeoMipErrors& errors, std::size_t number)
        : m_values(errors.m_values.data() + number * std::size_t(errors.m_stride)), m_errors(&errors) {}
    /// Of the regular grid of a level; no finer one is worse. 0 at level 0.
    float regular(int level) const { return level > 0 ? m_values[level - 1] : 0; }
    /// De Boer's measure: the largest change of height of a vertex that is left out on the way to a level,
    /// against the middle of the edge that takes its place. Not a bound.
    float midpoint(int level) const { return level > 0 ? m_values[m_errors->m_levels - 2 + level] : 0; }
    /// Of the strip at a side of the patch, drawn at `level`, with the border of a neighbour at `border`, at
    /// least `level`; no border between is worse. 0 for equal levels: that is regular().
    float stitched(int level, TeGeoMipSide side, int border) const {
      return border > level ? m_values[m_errors->offset(level, side, border)] : 0;
    }

  private:
    const float* m_values;
    const TeGeoMipErrors* m_errors;
  };
  Patch patch(int x, int y) const { return {*this, number(x, y)}; }

  std::size_t bytes() const {
    return m_values.capacity() * sizeof(float) + m_ranges.capacity() * sizeof(Range);
  }

private:
  std::size_t number(int x, int y) const { return std::size_t(y) * std::size_t(m_patches) + std::size_t(x); }
  /// Pairs level < border in order of rising border, then rising level.
  int offset(int level, TeGeoMipSide side, int border) const {
    return 2 * (m_levels - 1) + (border * (border - 1) / 2 + level) * 4 + int(side);
  }

  int m_levels;
  int m_patches;
  int m_stride; ///< numbers of a patch
  std::vector<float> m_values;
  std::vector<Range> m_ranges;
};
