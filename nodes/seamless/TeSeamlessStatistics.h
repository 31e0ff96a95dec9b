#pragma once

#include <cstddef>
#include <cstdint>

/// What drawing Seamless Patches cost in the last frame, and how good it is: the document's figures and more.
struct TeSeamlessStatistics {
  std::int64_t faces = 0; ///< triangles
  std::int64_t drawCalls = 0;
  std::int64_t traversed = 0; ///< patches of the tree
  std::int64_t culled = 0;
  std::int64_t rendered = 0;
  std::int64_t bytesUploaded = 0; ///< to OpenGL in this frame, all together
  /// CPU time of choosing patches and sorting them into lists; 0 if all was as in the frame before.
  double selectionSeconds = 0;
  /// Largest deviation of what was drawn from the full resolution, pixels; infinite if it is not known.
  double errorBound = 0;
  double precision = 0;             ///< factor of the document that would have drawn as finely everywhere
  double coarsening = 1;            ///< by which the accuracy was lowered for the sake of maxPatches
  int programs = 0;                 ///< shader programs compiled so far in the context
  std::size_t heightBytes = 0;      ///< main memory: height map, or the viewer's clip windows
  std::size_t clipTextureBytes = 0; ///< OpenGL: the viewer's clipmaps
};
