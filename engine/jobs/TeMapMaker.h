#pragma once

#include "engine/jobs/TeMapTask.h"
#include "engine/jobs/TeWorkerPool.h"
#include "patchdb/TeMapJob.h"
#include "patchdb/TeMapProvider.h"

#include <cstdint>
#include <map>

/// Source maps for all patch jobs of an engine in single flight: a map that several jobs need, one after the
/// other or at the same time, is made once. It is kept as long as a job has requested it; then the patches
/// that were made from it hold it.
///
/// Without workers a map is made in slices in the calling thread, on the allowance of the job that asks. With
/// workers it is handed over to one (one unit of the allowance) and made there with the same bits; it is
/// taken back by beginTick(), or by the job that asks for it again. Of handed-over maps there are at most as
/// many as kTaskBytes a worker hold, and kLeastTasks: enough for a worker's time between two ticks. What has
/// no room is made in the calling thread. Half-made ones there are at most kSlicedMaps (of more, the one
/// untouched for longest starts again), so that memory is bounded whatever the number of jobs. A map that no
/// job waits for any more is dropped, and its worker stopped at the next unit. Errors reach all jobs that
/// wait, and are forgotten with the last of them.
///
/// On the engine's thread only. The database must outlive it, and it the jobs' requests.
class TeMapMaker final : public TeMapProvider {
public:
  static constexpr std::size_t kTaskBytes = std::size_t(1) << 22;
  static constexpr std::size_t kLeastTasks = 2;
  static constexpr std::size_t kSlicedMaps = 16;

  explicit TeMapMaker(TePatchDatabase& database) : m_database(&database) {}
  ~TeMapMaker() override;
  TeMapMaker(const TeMapMaker&) = delete;
  TeMapMaker& operator=(const TeMapMaker&) = delete;

  /// 0 = none, at most TeWorkerPool::kMaxThreads. Maps that workers were making start again. Error, and no
  /// workers: the system gives fewer.
  TeStatus setWorkers(int workers);
  int workers() const { return m_pool ? m_pool->threads() : 0; }
  /// beginTick() waits for all that was handed over before, so that a run repeats whatever the speed of the
  /// workers.
  void setFixedJoin(bool fixed) { m_fixedJoin = fixed; }

  /// Takes finished maps from the workers, in the order of their keys. True if there were any.
  bool beginTick();
  /// The same after waiting for all that was handed over.
  bool joinAll();

  void request(TeMapKey key) override;
  void release(TeMapKey key) override;
  TeProgress provide(TeMapKey key, TeAllowance& allowance, TeSourceMapPtr& map, TeError& error) override;
  /// Takes the map back from a worker that is not done with it, and makes it in the calling thread.
  void hurry(TeMapKey key) override;
  bool blocked(TeMapKey key) const override;

  std::int64_t mapsMade() const { return m_made; }
  /// Requests for a map that was there already or being made.
  std::int64_t mapsShared() const { return m_shared; }
  /// Maps that are requested, and of them those handed over.
  std::size_t requested() const { return m_entries.size(); }
  std::size_t handedOver() const { return m_handedOver; }

private:
  struct Less {
    bool operator()(const TeMapKey& a, const TeMapKey& b) const { return a.y != b.y ? a.y < b.y : a.x < b.x; }
  };
  struct Entry {
    int requests = 0;
    bool hurried = false;
    TeSourceMapPtr map;
    std::optional<TeError> error;
    std::unique_ptr<TeMapJob> job; ///< in this thread
    std::uint64_t stepped = 0;     ///< when, counted in steps
    std::shared_ptr<TeMapTask> task;
  };
  std::size_t roomForTasks() const;
  template <class Work> void guarded(Entry& entry, Work work);
  void handOver(TeMapKey key, Entry& entry, TeAllowance& allowance);
  void slice(TeMapKey key, Entry& entry, TeAllowance& allowance);
  void begin(TeMapKey key, Entry& entry);
  void collect(TeMapKey key, Entry& entry);
  void dropTask(Entry& entry);

  TePatchDatabase* m_database;
  std::map<TeMapKey, Entry, Less> m_entries; ///< of all requested maps
  bool m_fixedJoin = false;
  std::size_t m_handedOver = 0;
  std::uint64_t m_steps = 0;
  std::int64_t m_made = 0;
  std::int64_t m_shared = 0;
  std::unique_ptr<TeWorkerPool> m_pool; ///< the first to go
};
