#pragma once

#include "nodes/seamless/TeSeamlessLayout.h"

#include <array>
#include <cstdint>
#include <vector>

inline int teDetailResolution(float detail) {
  const int below = int(detail);
  return below + (float(below) < detail);
}
/// Morph weight of a detail, 0 .. 255 for 0 .. 1, as instances carry it.
inline std::uint8_t teDetailWeight(float detail) {
  const float fraction = detail - float(int(detail));
  return fraction > 0 ? std::uint8_t(255 * fraction + 0.5f) : std::uint8_t(255);
}

/// One patch to be drawn: tile and strips follow from the detail of its sides.
///
/// The detail of a side is a resolution index with a fraction: a side of detail d is drawn at index
/// teDetailResolution(d), and its vertices that the next lower resolution lacks stand teDetailWeight(d) / 255
/// of the way from where the lower resolution has its surface to their own heights. Without geomorphing all
/// details are whole. Neighbours that share a side have the same detail there, or the deeper one has 0 and
/// the other its top.
struct TeSeamlessPatch {
  std::int16_t level = 0;
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::array<float, 4> detail{}; ///< by TeSide

  int resolution(int side) const { return teDetailResolution(detail[std::size_t(side)]); }
};

/// What a frame draws.
struct TeSeamlessSelection {
  std::vector<TeSeamlessPatch> patches;
  std::int64_t traversed = 0; ///< patches of the tree that were looked at
  std::int64_t culled = 0;    ///< of those, outside of what the camera sees
  std::int64_t triangles = 0;
  /// Largest deviation in pixels from the full resolution, over all that is drawn, is at most this; infinite
  /// if it is not known (no TeSeamlessBounds).
  double errorBound = 0;
  /// The document's precision factor that would have drawn every side at least as finely.
  double precision = 0;
  /// The accuracy had to be lowered by this factor (an exact one: to 1/64 pixel times it) to stay within the
  /// budget of patches; else 1.
  double coarsening = 1;
};
