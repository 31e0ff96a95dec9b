#pragma once

#include "generators/TeHeightMap.h"
#include "nodes/seamless/TeSeamlessLayout.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

struct TeHeightRange {
  float low = 0;
  float high = 0;

  friend bool operator==(const TeHeightRange& a, const TeHeightRange& b) {
    return a.low == b.low && a.high == b.high;
  }
  friend bool operator!=(const TeHeightRange& a, const TeHeightRange& b) { return !(a == b); }
};

/// What is known of the two patches at a side (or the one, on the rim) before any view: heights in the unit
/// of the samples.
struct TeSideBounds {
  /// Largest deviation from the samples when the side is drawn at resolution index i, of the two tiles at the
  /// side and the halves of strips beside them, whatever resolution their other sides have and however far
  /// they are morphed to the next lower resolution of this side. Not rising with i; 0 where every sample is
  /// a vertex. Entries above topIndex() equal that of topIndex(). Exact, in double precision, then rounded
  /// up; morphed vertices that are rounded when drawn may deviate by that rounding more.
  const float* error = nullptr;
  /// Range of the samples of both patches.
  TeHeightRange range;
  /// The patches at the side need not be divided for the side's sake if this deviation is small enough on the
  /// screen at a distance of no less than that to the box of TeSeamlessBounds::beyondAcross. 0 at the deepest
  /// level.
  float beyond = 0;
  TeHeightRange beyondRange; ///< of the samples in that box
};

/// Static data of a terrain for Seamless Patches: exact height errors by side and resolution, ranges of
/// heights by patch.
///
/// Contract (with r = kMorphRatio <= 1), for every side s above the deepest level: beyond(s) >=
/// error(s)[topIndex]; >= error(t)[0] of the children's sides t that are parts of s; >= beyond(t) / r for all
/// four sides t of each child, on both sides of s, that has a part of s for a side; and the box of s for
/// beyond encloses those of all these. So a patch that is divided has neighbours that are divided enough,
/// without asking them: docs/seamless-patches.md.
///
/// Immutable, thread-safe. Memory: about 4·(levels + 5)·2 + 8 bytes a patch.
class TeSeamlessBounds {
public:
  static constexpr float kMorphRatio = 0.8f;
  static constexpr std::int64_t kMaxPatches = std::int64_t(1) << 24;

  /// Gives `count` rows of layout.resolution() + 1 samples each, from row `row` on; row 0 in the south.
  using ReadRows = std::function<TeStatus(int row, int count, float* samples)>;
  /// Told the part that is done, 0 .. 1, now and then; false stops the work.
  using Progress = std::function<bool(double done)>;

  /// What is measured on the samples; all else follows from it.
  struct Measured {
    /// By tree level: errors of the sides by index, layout.levels() each.
    std::vector<std::vector<float>> errors;
    std::vector<TeHeightRange> ranges; ///< of the patches of the deepest level, row by row
  };

  /// From all samples, row 0 in the south. Error: a map of another size than layout.resolution() + 1, a
  /// missing sample (the message tells how many), too many patches, not enough memory.
  static TeResult<std::shared_ptr<const TeSeamlessBounds>> create(const TeSeamlessLayout& layout,
                                                                  const TeHeightMap& heights);
  /// The same, bit for bit, from samples that are not in memory together: some rows here and there, then all
  /// in order, up to `memory` bytes of them at a time (at least 16 rows). Error: also what `read` says, and
  /// "stopped".
  static TeResult<std::shared_ptr<const TeSeamlessBounds>> create(const TeSeamlessLayout& layout,
                                                                  const ReadRows& read,
                                                                  const Progress& progress = {},
                                                                  std::size_t memory = 24 << 20);
  /// Errors are made not to rise with the index. Error: arrays of other sizes than the layout asks for, a
  /// number that is not finite or an error or range that is negative, too many patches, not enough memory.
  static TeResult<std::shared_ptr<const TeSeamlessBounds>> create(const TeSeamlessLayout& layout,
                                                                  Measured measured);

  const TeSeamlessLayout& layout() const { return m_layout; }
  const Measured& measured() const { return m_measured; }
  TeHeightRange range(int level, std::int32_t x, std::int32_t y) const;
  TeSideBounds side(const TeSideKey& key) const;
  /// TeSideBounds::error alone.
  const float* errors(const TeSideKey& key) const {
    return m_measured.errors[std::size_t(key.level)].data() +
           m_layout.sideIndex(key) * std::ptrdiff_t(m_layout.levels());
  }
  /// Of the same; above the deepest level.
  float beyond(const TeSideKey& key) const {
    return m_beyond[std::size_t(key.level)][std::size_t(m_layout.sideIndex(key))];
  }
  TeHeightRange beyondRange(const TeSideKey& key) const {
    return m_beyondRanges[std::size_t(key.level)][std::size_t(m_layout.sideIndex(key))];
  }
  /// The box for TeSideBounds::beyond reaches so far on both sides of a side, and beyond both of its ends; in
  /// samples' distances. It may reach beyond the terrain. 0 at the deepest level.
  double beyondAcross(int level) const { return m_across[std::size_t(level)]; }
  double beyondAlong(int level) const { return m_along[std::size_t(level)]; }

private:
  TeSeamlessBounds(const TeSeamlessLayout& layout, Measured measured);
  void setRanges();
  void setBeyond(int level);
  float beyondOf(const TeSideKey& side) const;
  TeHeightRange rangeBeyond(const TeSideKey& side) const;

  TeSeamlessLayout m_layout;
  Measured m_measured;
  std::vector<std::vector<TeHeightRange>> m_ranges; ///< by tree level, without the deepest
  std::vector<std::vector<float>> m_beyond;         ///< by tree level and side, without the deepest
  std::vector<std::vector<TeHeightRange>> m_beyondRanges;
  std::vector<double> m_across;
  std::vector<double> m_along;
};
