#pragma once

#include "engine/jobs/TeJobKind.h"
#include "engine/jobs/TeUrgency.h"

#include <array>
#include <cstddef>
#include <vector>

/// Missing patches of which jobs are to be made, by kind, and how many are in the queue already. Of each kind
/// only the most urgent are kept, so that planning stays cheap however many are missing: where there were
/// more, they are looked for again once these have run out.
class TePatchCandidates {
public:
  /// Patches of a kind that are in the queue at most.
  static constexpr std::array<std::size_t, kTeJobKinds> kQueued = {256, 48, 16, 0};

  /// Begins a new search: forgets all candidates.
  void clear();
  void add(TeJobKind kind, const TeUrgency& urgency) { m_found[std::size_t(kind)].push_back(urgency); }
  /// Ends it.
  void sort();

  /// Takes the most urgent one of a kind that has room in the queue; false if there is none.
  bool take(TeJobKind kind, TeUrgency& urgency);
  bool empty() const;
  /// True if others have to be looked for.
  bool outdated() const;

  void clearQueued() { m_queued = {}; }
  void queued(TeJobKind kind) { ++m_queued[std::size_t(kind)]; }
  void unqueued(TeJobKind kind) { --m_queued[std::size_t(kind)]; }

private:
  std::array<std::vector<TeUrgency>, kTeJobKinds> m_found; ///< sorted, the most urgent last
  std::array<bool, kTeJobKinds> m_more{};                  ///< there were others, less urgent
  std::array<std::size_t, kTeJobKinds> m_queued{};
};
