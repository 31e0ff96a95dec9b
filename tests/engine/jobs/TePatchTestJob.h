#pragma once

#include "engine/jobs/TeJobQueue.h"
#include "engine/jobs/TeMapMaker.h"
#include "patchdb/TePatchJob.h"

/// A patch in slices as plain data: source maps, blending, arrays.
class TePatchTestJob final : public TeJob {
public:
  TePatchTestJob(TePatchDatabase& database, TeMapMaker& maker, TeJobKind kind, const TePatchKey& key)
      : TeJob(kind, {0, double(std::abs(key.x) + std::abs(key.y)), key}), m_database(&database),
        m_patch(database, key, &maker) {}

  TeProgress step(TeAllowance& allowance) override {
    if (m_patch.progress() == TeProgress::Working)
      if (const TeProgress progress = m_patch.step(allowance);
          progress != TeProgress::Done || allowance.exhausted())
        return fail(progress, m_patch);
    if (!m_arrays) {
      const TePatchData* patch = m_database->find(m_patch.key());
      if (!patch) { // someone has thrown it away
        m_error = {"gone"};
        return TeProgress::Failed;
      }
      TeResult<TeMeshBuilder> builder = m_database->meshBuilder(*patch);
      if (!builder) {
        m_error = builder.error();
        return TeProgress::Failed;
      }
      m_arrays.emplace(std::move(*builder));
    }
    return m_arrays->step(allowance) ? TeProgress::Done : TeProgress::Working;
  }

  TeJobState state() const override {
    if (m_arrays)
      return TeJobState::Arrays;
    switch (m_patch.stage()) {
    case TePatchJob::Stage::Waiting:
      return TeJobState::Waiting;
    case TePatchJob::Stage::SourceMaps:
      return TeJobState::SourceMaps;
    default:
      return TeJobState::Blend;
    }
  }
  bool blocked() const override { return m_patch.blocked(); }
  const TeError& error() const override { return m_error; }
  const TePatchKey& key() const { return m_patch.key(); }
  TePatchMesh takeMesh() { return m_arrays->take(); }

private:
  TeProgress fail(TeProgress progress, const TePatchJob& patch) {
    if (progress == TeProgress::Failed)
      m_error = patch.error();
    return progress == TeProgress::Failed ? progress : TeProgress::Working;
  }

  TePatchDatabase* m_database;
  TePatchJob m_patch;
  std::optional<TeMeshBuilder> m_arrays;
  TeError m_error;
};

/// A database, its maps and its queue, which go in the opposite order.
struct TePatchWorkshop {
  explicit TePatchWorkshop(std::unique_ptr<TePatchDatabase> made)
      : database(std::move(made)), maker(*database) {}

  void addBlock(int radius) {
    for (std::int64_t y = -radius; y <= radius; ++y)
      for (std::int64_t x = -radius; x <= radius; ++x) {
        const bool ground = x == 0 && y == 0;
        queue.add(std::make_unique<TePatchTestJob>(
            *database, maker, ground ? TeJobKind::Ground : TeJobKind::Block, TePatchKey{x, y, 0}));
      }
  }
  void tick(TeAllowance allowance) {
    maker.beginTick();
    queue.run(allowance);
  }

  std::unique_ptr<TePatchDatabase> database;
  TeMapMaker maker;
  TeJobQueue queue;
};
