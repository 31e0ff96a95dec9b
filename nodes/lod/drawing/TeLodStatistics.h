#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

/// What drawing with a LOD method cost in the last frame, and how good it is.
struct TeLodStatistics {
  std::int64_t triangles = 0;
  std::int64_t drawCalls = 0;
  std::int64_t parts = 0;   ///< TeLodPart
  std::int64_t visited = 0; ///< of the method's own nodes
  std::int64_t culled = 0;
  std::int64_t splits = 0; ///< by the last selection
  std::int64_t merges = 0;
  std::int64_t bytesUploaded = 0; ///< that OpenGL was given in this frame, all together
  std::int64_t keptParts = 0;     ///< that the viewer has for use again
  std::size_t keptBytes = 0;      ///< in OpenGL or main memory
  /// CPU time of choosing the triangles; 0 if all was as in the frame before.
  double selectionSeconds = 0;
  /// Largest deviation of what was drawn from the full resolution, pixels; infinite if it is not known.
  double errorBound = 0;
  /// The method's own dial, as given or as it would have been for so much accuracy; NaN if there is none.
  double dial = std::numeric_limits<double>::quiet_NaN();
  double coarsening = 1;  ///< by which the accuracy was lowered for the sake of maxTriangles
  bool isComplete = true; ///< false: the time slice ended first, and another frame follows
};
