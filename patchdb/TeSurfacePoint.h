#pragma once

#include "patchdb/TePatchKey.h"

/// The finest that is known of the surface at a point.
struct TeSurfacePoint {
  double height = 0;
  TePatchKey key;       ///< which patch answered
  double deviation = 0; ///< the base level's surface may lie this far away, metres; 0 at level 0
};
