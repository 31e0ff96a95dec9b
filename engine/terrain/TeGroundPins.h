#pragma once

#include "patchdb/TePatchKey.h"

#include <glm/vec3.hpp>

#include <unordered_map>
#include <vector>

class TeObject;

/// The patches below objects (all that they stand on, TeObject::groundReach()), and those on the way of the
/// next kSeconds, at most kPatchesAhead: each is wanted as long as an object needs it. Costs nothing for
/// objects that do not move.
class TeGroundPins {
public:
  static constexpr double kSeconds = 1;
  static constexpr int kPatchesAhead = 8;

  /// True if the object needs other patches than before, or none (outside the world). `ahead`: also those on
  /// its way.
  bool place(const TeObject& object, const TeLattice& lattice, bool ahead = true);
  void remove(const TeObject& object);

  bool holds(const TePatchKey& key) const { return m_counts.count(key) > 0; }
  /// visit(key), in no order.
  template <class Visit> void forEach(const Visit& visit) const {
    for (const auto& [key, count] : m_counts)
      visit(key);
  }

private:
  using Place = std::vector<TePatchKey>; ///< sorted, each once
  void findPlace(const TeObject& object, const TeLattice& lattice, bool ahead);
  void hold(const Place& place);
  void release(const Place& place);

  Place m_found; ///< by findPlace()
  std::unordered_map<const TeObject*, Place> m_places;
  std::unordered_map<TePatchKey, int, TePatchKeyHash> m_counts;
};
