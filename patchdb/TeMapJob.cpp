#include "patchdb/TeMapJob.h"

namespace {

TeError errorOf(TeMapKey key, const TeError& error) {
  return {"source map (" + std::to_string(key.x) + ", " + std::to_string(key.y) + "): " + error.message};
}

} // namespace

TeResult<std::unique_ptr<TeHeightJob>> teStartMap(TePatchDatabase& database, TeMapKey key) {
  const TeResult<TeHeightSourcePtr> source = database.mapSource(key);
  if (!source)
    return source.error();
  const TeWorld& world = database.world();
  const int samples = world.lattice.samples();
  if (TeStatus ok = (*source)->accepts(samples, samples); !ok)
    return errorOf(key, ok.error());
  return (*source)->start(TeMapRequest::sourceMap(world.lattice, world.seed, key));
}

TeResult<TeSourceMapPtr> teStoreMap(TePatchDatabase& database, TeMapKey key, TeHeightJob& ended) {
  if (ended.progress() == TeProgress::Failed)
    return errorOf(key, ended.error());
  TeHeightMap heights = ended.takeMap();
  const int samples = database.lattice().samples();
  if (heights.width() != samples || heights.height() != samples)
    return errorOf(key, {"the source made a map of another size than asked for"});
  return database.addMap(key, std::move(heights));
}

TeProgress TeMapJob::fail(const TeError& error) {
  m_error = error;
  m_job.reset();
  return TeProgress::Failed;
}

TeProgress TeMapJob::step(TeAllowance& allowance) {
  if (!m_error.message.empty())
    return TeProgress::Failed;
  if (!m_map)
    m_map = m_database->maps().find(m_key);
  if (m_map)
    return TeProgress::Done;
  if (!m_job) {
    TeResult<std::unique_ptr<TeHeightJob>> started = teStartMap(*m_database, m_key);
    if (!started)
      return fail(started.error());
    m_job = std::move(*started);
  }
  if (m_job->step(allowance) == TeProgress::Working)
    return TeProgress::Working;
  TeResult<TeSourceMapPtr> stored = teStoreMap(*m_database, m_key, *m_job);
  if (!stored)
    return fail(stored.error());
  m_job.reset();
  m_map = std::move(*stored);
  return TeProgress::Done;
}
