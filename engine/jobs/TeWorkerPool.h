#pragma once

#include "engine/jobs/TeWorkerTask.h"

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

/// Threads that run tasks, those handed over first first. All members are for one thread, that of the owner.
class TeWorkerPool {
public:
  static constexpr int kMaxThreads = 64;

  /// Error: not 1 .. kMaxThreads threads, or the system gives fewer.
  static TeResult<std::unique_ptr<TeWorkerPool>> create(int threads);
  /// Cancels all tasks and waits for those that run: as long as they take to notice.
  ~TeWorkerPool();
  TeWorkerPool(const TeWorkerPool&) = delete;
  TeWorkerPool& operator=(const TeWorkerPool&) = delete;

  int threads() const { return int(m_threads.size()); }
  void submit(std::shared_ptr<TeWorkerTask> task);
  /// Blocks until the task, which was submitted, has ended.
  void waitFor(const TeWorkerTask& task);
  /// Blocks until all tasks have ended.
  void waitForAll();

private:
  TeWorkerPool() = default;
  void work();

  std::mutex m_mutex;
  std::condition_variable m_submitted;
  std::condition_variable m_ended;
  std::deque<std::shared_ptr<TeWorkerTask>> m_tasks; ///< not begun
  std::vector<std::shared_ptr<TeWorkerTask>> m_running;
  bool m_stop = false;
  std::vector<std::thread> m_threads;
};
