#pragma once

#include "engine/objects/TeObject.h"
#include "generators/base/TeResult.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class TePatchDatabase;

/// All objects of a world, in the order in which they were added.
///
/// A tick visits only those that are awake, in order of addition, whatever woke them; one that rests costs
/// nothing. For the thread that makes all Coin calls. Objects may add, remove and wake objects, themselves
/// too, while they are updated: what is new or woken is updated from the next step on, and what is removed is
/// deleted at the end of the tick.
class TeObjects {
public:
  static constexpr double kLongestStep = 0.1; ///< seconds
  static constexpr double kLongestTick = 1.0;

  struct Tick {
    double simulated = 0; ///< seconds
    double dropped = 0;   ///< of dt, beyond kLongestTick
    int steps = 0;
    std::int64_t updates = 0;
    std::int64_t held = 0; ///< updates left out because the ground below was not known
    /// Objects that were put back and stopped because their update left something that is not finite.
    std::vector<std::string> errors;
  };

  TeObjects();
  ~TeObjects();
  TeObjects(const TeObjects&) = delete;
  TeObjects& operator=(const TeObjects&) = delete;

  /// Owns the object from now on; it is awake. Error: null, or a place that is not finite.
  TeResult<TeObject*> add(std::unique_ptr<TeObject> object);
  /// False: not one of these.
  bool remove(const TeObject* object);
  bool contains(const TeObject* object) const;
  const std::vector<std::unique_ptr<TeObject>>& all() const { return m_all; }

  /// Simulates dt in equal steps of at most kLongestStep, all awake objects in each; 0 updates nothing. An
  /// object that needsGround() is held where the surface below is not known: it stays awake as it is.
  /// Error, and nothing done: dt is negative or not finite.
  TeResult<Tick> update(double dt, const TePatchDatabase& terrain);
  double time() const { return m_time; } ///< simulated seconds

  /// Those that are awake, in order of addition. Not during update().
  const std::vector<TeObject*>& awake();
  bool anyAwake() const { return !m_awake.empty() || !m_woken.empty(); }
  /// Those that the last update() met awake: only these may have moved in it. In no particular order.
  const std::vector<TeObject*>& touched() const { return m_touched; }

  /// Of all objects in order of addition.
  std::uint64_t stateHash() const;

private:
  friend class TeObject;
  using Owned = std::vector<std::unique_ptr<TeObject>>;

  void woken(TeObject& object) { m_woken.push_back(&object); }
  void admitWoken();
  void step(const TeUpdate& update, Tick& tick);
  /// False: it is held, or was stopped.
  bool updateOne(TeObject& object, const TeUpdate& update, Tick& tick);
  Owned::const_iterator find(const TeObject* object) const;

  Owned m_all;
  std::vector<TeObject*> m_awake; ///< by order; null while updating: removed
  std::vector<TeObject*> m_woken; ///< since the last step, in any order
  std::vector<TeObject*> m_touched;
  Owned m_removed; ///< while updating, deleted at its end
  std::uint64_t m_added = 0;
  double m_time = 0;
  bool m_updating = false;
};
