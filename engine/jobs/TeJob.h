#pragma once

#include "engine/jobs/TeJobKind.h"
#include "engine/jobs/TeJobState.h"
#include "engine/jobs/TeUrgency.h"
#include "generators/TeHeightSource.h"
#include "generators/base/TeAllowance.h"
#include "generators/base/TeResult.h"

/// Work that an engine does in slices between frames. Derive, implement step() and state(), and give it to a
/// TeJobQueue (programs: TeEngine::addJob). On the engine's thread only; see TeWorkerPool for others.
class TeJob {
public:
  virtual ~TeJob();
  TeJob(const TeJob&) = delete;
  TeJob& operator=(const TeJob&) = delete;

  /// Does units of work, each at most about 0.25 ms, until the allowance is spent, at least one unless
  /// blocked(). After Done or Failed it is not called again. It may throw std::bad_alloc, which fails the
  /// job.
  virtual TeProgress step(TeAllowance& allowance) = 0;
  virtual TeJobState state() const = 0;
  /// True if it waits for a worker: step() would do nothing.
  virtual bool blocked() const { return false; }
  /// Only after step() has returned Failed.
  virtual const TeError& error() const = 0;
  /// Why it failed: error(), or a lack of memory.
  TeError failure() const { return m_outOfMemory ? TeError{"out of memory"} : error(); }

  TeJobKind kind() const { return m_kind; }
  const TeUrgency& urgency() const { return m_urgency; }

protected:
  TeJob(TeJobKind kind, const TeUrgency& urgency) : m_kind(kind), m_urgency(urgency) {}

private:
  friend class TeJobQueue;
  TeJobKind m_kind;
  TeUrgency m_urgency;
  bool m_outOfMemory = false;
};
