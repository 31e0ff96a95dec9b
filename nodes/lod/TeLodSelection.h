#pragma once

#include <cstdint>
#include <limits>
#include <vector>

/// How accurate a frame is to be.
struct TeLodAccuracy {
  /// Wanted largest screen error: vertical deviation from the surface of all samples · focal length /
  /// distance (TeLodView::pixels). Not negative; 0: every sample in view is a vertex.
  double pixelError = 1;
  /// The method's own dial (TeLodDial) in place of pixelError, if more than 0.
  double dial = 0;
  /// Vertices move smoothly between levels, if the method can (TeLodMethod::morphs()).
  bool geomorph = false;
  /// Budget; the accuracy is lowered where more would be needed.
  std::int64_t maxTriangles = std::int64_t(1) << 22;
};

/// Triangles that stay together. The same key means the same triangles, bit for bit, as long as the method
/// lives: what was made of them, such as a buffer of OpenGL, may be used again.
struct TeLodPart {
  std::uint64_t key = 0;
  std::int64_t triangles = 0; ///< with skirts
};

/// What a frame draws, and what that is worth.
struct TeLodSelection {
  std::vector<TeLodPart> parts;
  std::int64_t triangles = 0; ///< of all parts
  std::int64_t visited = 0;   ///< of the method's own nodes, looked at
  std::int64_t culled = 0;    ///< of those, not in view
  std::int64_t splits = 0;    ///< changes of a mesh that is kept from frame to frame
  std::int64_t merges = 0;
  /// No sample in view deviates by more pixels; infinite if the method cannot tell.
  double errorBound = std::numeric_limits<double>::infinity();
  /// The method's dial: as given, or what it would have been for so much accuracy. NaN if it has none.
  double dial = std::numeric_limits<double>::quiet_NaN();
  /// The accuracy had to be lowered by this factor to keep the budget (an exact one: to 1/64 pixel times it).
  double coarsening = 1;
  /// False: the slice ended first. The triangles fit each other and errorBound holds, but it may be above
  /// what was wanted.
  bool complete = true;
};
