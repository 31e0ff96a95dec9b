#pragma once

#include "generators/TeHeightMap.h"
#include "nodes/seamless/TeSeamlessLayout.h"

#include <cstdint>
#include <memory>
#include <vector>

struct TeHeightRange {
  float low = 0;
  float high = 0;
};

/// What is known of the two patches at a side (or the one, on the rim) before any view: heights in the unit
/// of the samples.
struct TeSideBounds {
  /// Largest deviation from the samples when the side is drawn at resolution index i, of the two tiles at the
  /// side and the halves of strips beside them, whatever resolution their other sides have and however far
  /// they are morphed to the next lower resolution of this side. Not rising with i; 0 where every sample is
  /// a vertex. Entries above topIndex() equal that of topIndex().
  const float* error = nullptr;
  /// Range of the samples of both patches.
  TeHeightRange range;
  /// The patches at the side need not be divided for the side's sake if this deviation is small enough on the
  /// screen at a distance of no less than that to TeSeamlessBounds::beyondBox. 0 at the deepest level.
  float beyond = 0;
  TeHeightRange beyondRange;
};

/// Static data of a terrain for Seamless Patches: exact height errors by side and resolution, ranges of
/// heights by patch.
///
/// Contract (with r = kMorphRatio <= 1): beyond(s) >= error(s)[topIndex]; >= error(t)[0] of the children's
/// sides t that are parts of s; >= beyond(t) / r for all sides t of all children, on both sides of s, that
/// touch s in more than a point; and the box of s for beyond encloses those of all these. So a patch that is
/// divided has neighbours that are divided enough, without asking them: docs/seamless-patches.md.
///
/// Immutable, thread-safe. Memory: about 4·(levels + 5)·2 + 8 bytes a patch.
class TeSeamlessBounds {
public:
  static constexpr float kMorphRatio = 0.8f;
  static constexpr std::int64_t kMaxPatches = std::int64_t(1) << 24;

  /// From all samples, row 0 in the south. Error: a map of another size than layout.resolution() + 1, a
  /// missing sample (the message tells how many), too many patches, not enough memory.
  static TeResult<std::shared_ptr<const TeSeamlessBounds>> create(const TeSeamlessLayout& layout,
                                                                  const TeHeightMap& heights);

  const TeSeamlessLayout& layout() const { return m_layout; }
  TeHeightRange range(int level, std::int32_t x, std::int32_t y) const;
  TeSideBounds side(const TeSideKey& key) const;
  /// How far the box for TeSideBounds::beyond reaches on both sides of a side, and beyond both of its ends;
  /// in samples' distances.
  double beyondAcross(int level) const;
  double beyondAlong(int level) const;

private:
  explicit TeSeamlessBounds(const TeSeamlessLayout& layout) : m_layout(layout) {}

  TeSeamlessLayout m_layout;
};
