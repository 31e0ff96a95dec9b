#include "engine/jobs/TeMapMaker.h"

#include <algorithm>
#include <new>

TeMapMaker::~TeMapMaker() = default;

TeStatus TeMapMaker::setWorkers(int workers) {
  if (workers == this->workers())
    return {};
  for (auto& [key, entry] : m_entries)
    dropTask(entry);
  m_pool.reset();
  if (workers == 0)
    return {};
  TeResult<std::unique_ptr<TeWorkerPool>> pool = TeWorkerPool::create(workers);
  if (!pool)
    return pool.error();
  m_pool = std::move(*pool);
  return {};
}

void TeMapMaker::request(TeMapKey key) {
  const auto [at, isNew] = m_entries.try_emplace(key);
  Entry& entry = at->second;
  ++entry.requests;
  if (isNew)
    entry.map = m_database->maps().find(key);
  if (!isNew || entry.map)
    ++m_shared;
}

void TeMapMaker::release(TeMapKey key) {
  const auto at = m_entries.find(key);
  assert(at != m_entries.end());
  if (--at->second.requests > 0)
    return;
  dropTask(at->second);
  m_entries.erase(at);
}

void TeMapMaker::dropTask(Entry& entry) {
  if (!entry.task)
    return;
  entry.task->cancel();
  entry.task.reset();
  --m_handedOver;
}

std::size_t TeMapMaker::roomForTasks() const {
  const std::size_t samples = std::size_t(m_database->lattice().samples());
  const std::size_t fitting = kTaskBytes / (samples * samples * sizeof(float));
  const std::size_t most = std::max(fitting, kLeastTasks) * std::size_t(workers());
  return most - std::min(most, m_handedOver);
}

bool TeMapMaker::blocked(TeMapKey key) const {
  const auto at = m_entries.find(key);
  if (at == m_entries.end())
    return false;
  const Entry& entry = at->second;
  return entry.task && (m_fixedJoin || !entry.task->ended());
}

void TeMapMaker::hurry(TeMapKey key) {
  const auto at = m_entries.find(key);
  assert(at != m_entries.end());
  Entry& entry = at->second;
  entry.hurried = true;
  if (entry.task && (m_fixedJoin || !entry.task->ended()))
    dropTask(entry);
}

/// Work on a map that may run out of memory: what was made of it then is dropped.
template <class Work> void TeMapMaker::guarded(Entry& entry, Work work) {
  try {
    work();
  } catch (const std::bad_alloc&) {
    dropTask(entry);
    entry.job.reset();
    entry.error = TeError{"out of memory"}; // short enough to need none
  }
}

TeProgress TeMapMaker::provide(TeMapKey key, TeAllowance& allowance, TeSourceMapPtr& map, TeError& error) {
  const auto at = m_entries.find(key);
  assert(at != m_entries.end());
  Entry& entry = at->second;
  if (!entry.map && !entry.error)
    guarded(entry, [&] {
      if (entry.task) {
        if (!m_fixedJoin && entry.task->ended())
          collect(key, entry);
      } else if (m_pool && !entry.job && !entry.hurried && roomForTasks() > 0) {
        handOver(key, entry, allowance);
      } else {
        slice(key, entry, allowance);
      }
    });
  if (entry.error) {
    error = *entry.error;
    return TeProgress::Failed;
  }
  map = entry.map;
  return map ? TeProgress::Done : TeProgress::Working;
}

void TeMapMaker::handOver(TeMapKey key, Entry& entry, TeAllowance& allowance) {
  TeResult<std::unique_ptr<TeHeightJob>> started = teStartMap(*m_database, key);
  if (!started) {
    entry.error = started.error();
    return;
  }
  auto task = std::make_shared<TeMapTask>(std::move(*started));
  m_pool->submit(task);
  entry.task = std::move(task);
  ++m_handedOver;
  allowance.spend();
}

void TeMapMaker::slice(TeMapKey key, Entry& entry, TeAllowance& allowance) {
  if (!entry.job)
    begin(key, entry);
  entry.stepped = ++m_steps;
  const TeProgress progress = entry.job->step(allowance);
  if (progress == TeProgress::Working)
    return;
  if (progress == TeProgress::Failed) {
    entry.error = entry.job->error();
  } else {
    entry.map = entry.job->map();
    ++m_made;
  }
  entry.job.reset();
}

void TeMapMaker::begin(TeMapKey key, Entry& entry) {
  std::size_t begun = 0;
  Entry* oldest = nullptr;
  for (auto& [otherKey, other] : m_entries)
    if (other.job) {
      ++begun;
      if (!oldest || other.stepped < oldest->stepped)
        oldest = &other;
    }
  if (begun >= kSlicedMaps)
    oldest->job.reset();
  entry.job = std::make_unique<TeMapJob>(*m_database, key);
}

bool TeMapMaker::beginTick() {
  if (m_fixedJoin)
    return joinAll();
  const std::size_t before = m_handedOver;
  for (auto& [key, entry] : m_entries)
    if (entry.task && entry.task->ended())
      guarded(entry, [&, &key = key, &entry = entry] { collect(key, entry); });
  return m_handedOver < before;
}

bool TeMapMaker::joinAll() {
  const std::size_t before = m_handedOver;
  for (auto& [key, entry] : m_entries)
    if (entry.task) {
      m_pool->waitFor(*entry.task);
      guarded(entry, [&, &key = key, &entry = entry] { collect(key, entry); });
    }
  return before > 0;
}

void TeMapMaker::collect(TeMapKey key, Entry& entry) {
  const std::shared_ptr<TeMapTask> task = std::move(entry.task);
  --m_handedOver;
  if (!task->status()) {
    entry.error = task->status().error();
    return;
  }
  TeResult<TeSourceMapPtr> stored = teStoreMap(*m_database, key, task->job());
  if (!stored) {
    entry.error = stored.error();
    return;
  }
  entry.map = std::move(*stored);
  ++m_made;
}
