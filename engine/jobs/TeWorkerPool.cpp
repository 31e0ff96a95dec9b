#include "engine/jobs/TeWorkerPool.h"

#include <algorithm>
#include <string>
#include <system_error>

TeResult<std::unique_ptr<TeWorkerPool>> TeWorkerPool::create(int threads) {
  if (threads < 1 || threads > kMaxThreads)
    return TeError{"workers: " + std::to_string(threads) + " threads are not within 1 to " +
                   std::to_string(kMaxThreads)};
  std::unique_ptr<TeWorkerPool> pool(new TeWorkerPool);
  pool->m_running.reserve(std::size_t(threads)); // so that work() needs no memory
  pool->m_threads.reserve(std::size_t(threads));
  try {
    while (pool->threads() < threads)
      pool->m_threads.emplace_back([&pool = *pool] { pool.work(); });
  } catch (const std::system_error& error) {
    return TeError{"workers: no more than " + std::to_string(pool->threads()) +
                   " threads can be started: " + error.what()};
  }
  return pool;
}

TeWorkerPool::~TeWorkerPool() {
  {
    const std::lock_guard lock(m_mutex);
    m_stop = true;
    for (const auto& task : m_tasks)
      task->cancel();
    for (const auto& task : m_running)
      task->cancel();
  }
  m_submitted.notify_all();
  for (std::thread& thread : m_threads)
    thread.join();
}

void TeWorkerPool::submit(std::shared_ptr<TeWorkerTask> task) {
  {
    const std::lock_guard lock(m_mutex);
    m_tasks.push_back(std::move(task));
  }
  m_submitted.notify_one();
}

void TeWorkerPool::waitFor(const TeWorkerTask& task) {
  std::unique_lock lock(m_mutex);
  m_ended.wait(lock, [&] { return task.ended(); });
}

void TeWorkerPool::waitForAll() {
  std::unique_lock lock(m_mutex);
  m_ended.wait(lock, [&] { return m_tasks.empty() && m_running.empty(); });
}

void TeWorkerPool::work() {
  std::unique_lock lock(m_mutex);
  for (;;) {
    m_submitted.wait(lock, [&] { return m_stop || !m_tasks.empty(); });
    if (m_tasks.empty())
      return;
    std::shared_ptr<TeWorkerTask> task = std::move(m_tasks.front());
    m_tasks.pop_front();
    m_running.push_back(task);
    lock.unlock();
    task->runToEnd();
    lock.lock();
    m_running.erase(std::find(m_running.begin(), m_running.end(), task));
    task->m_ended.store(true, std::memory_order_release);
    m_ended.notify_all();
    // What it holds may take long to free.
    lock.unlock();
    task.reset();
    lock.lock();
  }
}
