#pragma once

#include "generators/TeLattice.h"

#include <glm/vec2.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

/// The eight directions around a patch, counter-clockwise from east. North is +y.
enum class TeDirection { East, NorthEast, North, NorthWest, West, SouthWest, South, SouthEast };
inline constexpr std::array<TeDirection, 8> kTeDirections = {
    TeDirection::East, TeDirection::NorthEast, TeDirection::North, TeDirection::NorthWest,
    TeDirection::West, TeDirection::SouthWest, TeDirection::South, TeDirection::SouthEast};
constexpr TeDirection teOpposite(TeDirection d) { return TeDirection((int(d) + 4) % 8); }
/// Step in keys: -1, 0 or 1 each.
glm::ivec2 teStep(TeDirection direction);

/// Names a patch: column and row of its level. Level 0 is the base; a patch of level L covers the 2^L × 2^L
/// base patches x·2^L .. x·2^L + 2^L - 1 (and the same in y), with as many samples as one of them.
/// Keys are floor-aligned: parent() of x is floor(x / 2), also below zero.
///
/// A world has the base patches -2^47 .. 2^47 - 1 in x and y, so that every patch has an ancestor at every
/// level up to kMaxLevel, where four patches (x, y in {-1, 0}) cover everything; source maps then have the
/// keys -2^47 .. 2^47. Functions that make a key out of a valid one give a valid one or an error, never an
/// overflow.
struct TePatchKey {
  static constexpr int kMaxLevel = 47;

  std::int64_t x = 0;
  std::int64_t y = 0;
  int level = 0;

  /// Level 0 .. kMaxLevel, x and y in -2^(47-level) .. 2^(47-level) - 1.
  bool valid() const;

  /// Error beyond the largest level or of an invalid key.
  TeResult<TePatchKey> parent() const;
  /// Child 0 = south-west, 1 = south-east, 2 = north-west, 3 = north-east; error at level 0.
  TeResult<TePatchKey> child(int index) const;
  /// Which child of its parent this is, 0 .. 3.
  int childIndex() const;
  /// The patch of the same level next to this one; error at the rim of the world.
  TeResult<TePatchKey> neighbour(TeDirection direction) const;
  /// The ancestor at a level, which must not be below this one; the key itself at its own level.
  TeResult<TePatchKey> ancestor(int level) const;
  /// True if `other` is this patch or one of its descendants.
  bool contains(const TePatchKey& other) const;

  std::string text() const; ///< "(x, y) level L"

  friend bool operator==(const TePatchKey& a, const TePatchKey& b) {
    return a.x == b.x && a.y == b.y && a.level == b.level;
  }
  friend bool operator!=(const TePatchKey& a, const TePatchKey& b) { return !(a == b); }
  /// By level, then y, then x: the last tie-breaker of every priority.
  friend bool operator<(const TePatchKey& a, const TePatchKey& b);
};

struct TePatchKeyHash {
  std::size_t operator()(const TePatchKey& key) const;
};

/// The patch of a level that contains a point (half-open: the west and south borders belong to it). Error:
/// the point is not finite or outside the world, the level does not exist.
TeResult<TePatchKey> tePatchAt(const TeLattice& lattice, glm::dvec2 point, int level = 0);

/// Global number of the base sample in the patch's south-west corner. Sample (i, j) of the patch,
/// 0 <= i, j <= n, is the base sample with that number + (i, j)·2^level. The key must be valid.
glm::vec<2, std::int64_t> tePatchFirstSample(const TeLattice& lattice, const TePatchKey& key);
/// The patch's south-west corner and its centre, metres. The key must be valid.
glm::dvec2 tePatchOrigin(const TeLattice& lattice, const TePatchKey& key);
glm::dvec2 tePatchCentre(const TeLattice& lattice, const TePatchKey& key);
