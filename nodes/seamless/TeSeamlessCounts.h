#pragma once

#include <cstdint>

/// What drawing a frame of Seamless Patches took.
struct TeSeamlessCounts {
  std::int64_t drawCalls = 0;
  std::int64_t triangles = 0;
  std::int64_t instances = 0; ///< whole patches, or parts of them
  std::int64_t bytesUploaded = 0;
};
