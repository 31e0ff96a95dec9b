#pragma once

#include "generators/base/TeResult.h"

#include <atomic>

/// A piece of work for a thread of a TeWorkerPool: fills plain memory of its own, calls nothing of Coin,
/// OpenGL or the engine, and reads nothing that others may change.
class TeWorkerTask {
public:
  virtual ~TeWorkerTask();
  TeWorkerTask(const TeWorkerTask&) = delete;
  TeWorkerTask& operator=(const TeWorkerTask&) = delete;

  /// True when it has run, has failed, or was cancelled before it began. Its results may be read then, by any
  /// thread. Any thread may ask.
  bool ended() const { return m_ended.load(std::memory_order_acquire); }
  /// How it ended; once ended().
  const TeStatus& status() const { return m_status; }

  /// Asks it to end soon, with whatever result. From any thread.
  void cancel() { m_cancelled.store(true, std::memory_order_relaxed); }
  bool cancelled() const { return m_cancelled.load(std::memory_order_relaxed); }

protected:
  TeWorkerTask() = default;
  /// All of the work, on a worker. Looks at cancelled() between slices of at most some milliseconds.
  virtual TeStatus run() = 0;

private:
  friend class TeWorkerPool;
  /// Runs it unless it was cancelled; a lack of memory is an error.
  void runToEnd();

  std::atomic<bool> m_cancelled{false};
  std::atomic<bool> m_ended{false};
  TeStatus m_status;
};
