#pragma once

#include "patchdb/TePatchKey.h"

#include <glm/vec2.hpp>

#include <vector>

/// Foresees over which patches an object will be soon, so that their blocks are made before it is there.
struct TeLookAhead {
  /// An object nearer to an edge of its patch than this part of the side may cross it next, whatever its
  /// velocity. It then needs 2r + 1 patches more, near a corner 4r + 1: 3 and 5 for r = 1.
  static constexpr double kEdge = 0.25;
  /// Along the velocity.
  static constexpr double kSeconds = 1.5;
  static constexpr int kMaxCentres = 64;

  /// In the order in which they will be reached, neighbours of the object's own patch first; without the
  /// latter, without repetitions, at most kMaxCentres, only keys that exist.
  static std::vector<TePatchKey> centres(const TeLattice& lattice, glm::dvec2 position, glm::dvec2 velocity);
};
