#pragma once

#include "engine/TeStatistics.h"
#include "engine/jobs/TeJob.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

/// All work to be done, most urgent first, within an allowance a tick.
///
/// Ground comes first, as much as the allowance holds. The rest is divided: each other kind that has work is
/// sure of its share of the units (kShares), taken over the ticks, so that none starves; what a kind does not
/// use goes to the most urgent kind (Block, Ahead, Other in this order). Within a kind: TeUrgency. The order
/// depends on urgencies and units alone, never on the order of insertion or on time; jobs of equal urgency,
/// key included, are not told apart.
/// A job that is found blocked is passed over until the next run().
/// On the engine's thread only. Costs of 1,000 jobs (tests/bench/jobs.cpp): a review with another order
/// 0.08 ms, adding or cancelling 1 µs; of a step 50 ns and the clock.
class TeJobQueue {
public:
  /// Shares of Block, Ahead and Other in what Ground leaves.
  static constexpr std::array<double, kTeJobKinds> kShares = {0, 0.7, 0.2, 0.1};
  /// Asked when urgencies are found anew. Returning false cancels the job. Must not change the queue.
  using Review = std::function<bool(TeJob& job, TeJobKind& kind, TeUrgency& urgency)>;
  /// Told when a job is done or has failed, before it is deleted. It may add and cancel jobs.
  using Finished = std::function<void(TeJob& job, TeProgress progress)>;

  TeJobQueue();
  ~TeJobQueue(); ///< drops what is left, in whatever state
  TeJobQueue(const TeJobQueue&) = delete;
  TeJobQueue& operator=(const TeJobQueue&) = delete;

  void setFinished(Finished finished) { m_finished = std::move(finished); }

  /// The queue owns the job until it is done, failed or cancelled.
  TeJob& add(std::unique_ptr<TeJob> job);
  /// Deletes it at once, whatever its state; the one that is stepping, when its step has ended. It must be in
  /// the queue.
  void cancel(const TeJob& job);
  void clear();
  /// Asks for every job whether it is still wanted, and how urgently.
  void review(const Review& review);

  /// Steps jobs until the allowance is spent, nothing is left, or all that is left is blocked; one at least,
  /// unless there is none. True if units were spent.
  bool run(TeAllowance& allowance);

  bool empty() const { return size() == 0; }
  std::size_t size() const;
  /// True if there are jobs, and all of them are blocked.
  bool allBlocked() const;
  /// Fills in the numbers of jobs: now, by kind and state, and started, finished, cancelled and failed since
  /// the queue was made, by the kind that they had last.
  void count(TeStatistics::Jobs& jobs) const;

private:
  /// With the first parts of the urgency at hand.
  struct Slot {
    int rank;
    double distance;
    std::unique_ptr<TeJob> job;
    bool started;
    bool cancelled;
    bool operator<(const Slot& other) const;
  };
  using Slots = std::vector<Slot>; ///< most urgent first

  struct Kind {
    Slots slots;
    std::size_t next = 0; ///< those before it were found blocked
    double credit = 0;    ///< units that it may take before the others
    std::int64_t started = 0;
    std::int64_t finished = 0;
    std::int64_t cancelled = 0;
    std::int64_t failed = 0;
  };

  Kind& kind(TeJobKind which) { return m_kinds[std::size_t(which)]; }
  static Slot makeSlot(std::unique_ptr<TeJob> job, bool started);
  void insert(Slot slot);
  Slots::iterator find(const TeJob& job);
  static bool findReady(Kind& kind);
  Kind* mostUrgentKind();
  static TeProgress stepOf(TeJob& job, TeAllowance& allowance);
  void step(Kind& kind, TeAllowance& allowance);
  void share(const Kind& worker, std::int64_t units);

  std::array<Kind, kTeJobKinds> m_kinds;
  const TeJob* m_stepping = nullptr;
  Finished m_finished;
};
