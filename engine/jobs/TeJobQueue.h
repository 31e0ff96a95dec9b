#pragma once

#include "engine/TeStatistics.h"
#include "engine/jobs/TeJob.h"

#include <array>
#include <functional>
#include <memory>
#include <vector>

/// All work to be done, most urgent first, within an allowance a tick.
///
/// Ground comes first, as much as the allowance holds. The rest is divided: each other kind that has work is
/// sure of its share of the units (kShares), taken over the ticks, so that none starves; what a kind does not
/// use goes to the most urgent kind (Block, Ahead, Other in this order). Within a kind: TeUrgency. The order
/// depends on urgencies and units alone, never on the order of insertion or on time.
/// On the engine's thread only.
class TeJobQueue {
public:
  /// Shares of Block, Ahead and Other in what Ground leaves.
  static constexpr std::array<double, kTeJobKinds> kShares = {0, 0.7, 0.2, 0.1};
  /// Asked when urgencies are found anew. Returning false cancels the job.
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
  /// Deletes it at once, whatever its state. It must be in the queue, and not be the one that is stepping.
  void cancel(const TeJob& job);
  void clear();
  /// Asks for every job whether it is still wanted, and how urgently.
  void review(const Review& review);

  /// Steps jobs until the allowance is spent, nothing is left, or all that is left is blocked. True if units
  /// were spent.
  bool run(TeAllowance& allowance);

  bool empty() const;
  std::size_t size() const;
  bool allBlocked() const;
  /// Adds its counts by kind and state to the record.
  void count(TeStatistics::Jobs& jobs) const;

private:
  Finished m_finished;
};
