#pragma once

#include "patchdb/TePatchKey.h"

#include <glm/vec3.hpp>

#include <array>
#include <optional>
#include <unordered_map>

class TeObject;

/// The patches below objects (all that they stand on, TeObject::groundReach()), and where these will be in
/// kSeconds: each is wanted as long as an object is over it. Costs nothing for objects that do not move.
class TeGroundPins {
public:
  static constexpr double kSeconds = 1;

  /// True if the object is over other patches than before, or none (outside the world).
  bool place(const TeObject& object, const TeLattice& lattice);
  void remove(const TeObject& object);

  bool holds(const TePatchKey& key) const { return m_counts.count(key) > 0; }
  /// visit(key), in no order.
  template <class Visit> void forEach(const Visit& visit) const {
    for (const auto& [key, count] : m_counts)
      visit(key);
  }

private:
  /// Now and soon, at the corners of what it reaches; a patch counts once for each corner.
  using Place = std::array<std::optional<TePatchKey>, 8>;
  void hold(const Place& place);
  void release(const Place& place);

  std::unordered_map<const TeObject*, Place> m_places;
  std::unordered_map<TePatchKey, int, TePatchKeyHash> m_counts;
};
