#include "patchdb/TePatchJob.h"

TePatchJob::TePatchJob(TePatchDatabase& database, const TePatchKey& key) : m_database(&database), m_key(key) {
  if (!key.valid())
    m_progress = fail({"outside the world"});
  else if (key.level != 0)
    m_progress = fail({"only patches of level 0 are made from source maps"});
}

TeProgress TePatchJob::fail(const TeError& error) {
  m_error.message = "patch " + m_key.text() + ": " + error.message;
  m_mapJob.reset();
  m_builder.reset();
  return TeProgress::Failed;
}

TeProgress TePatchJob::step(TeAllowance& allowance) {
  if (m_progress != TeProgress::Working)
    return m_progress;
  const TeProgress maps = makeMaps(allowance);
  if (maps == TeProgress::Done)
    m_progress = makeHeights(allowance);
  else if (maps == TeProgress::Failed)
    m_progress = maps;
  return m_progress;
}

TeProgress TePatchJob::finish() {
  TeAllowance all = TeAllowance::unlimited();
  return step(all);
}

TeProgress TePatchJob::makeMaps(TeAllowance& allowance) {
  if (m_progress == TeProgress::Failed)
    return m_progress;
  if (!m_needed) {
    // All four sources are remembered even where one map is enough: the neighbours share the others.
    std::array<TeHeightSourcePtr, 4> sources;
    for (int corner = 0; corner < 4; ++corner) {
      const TeResult<TeHeightSourcePtr> source = m_database->mapSource(teMapKey(m_key, corner));
      if (!source)
        return fail(source.error());
      sources[std::size_t(corner)] = *source;
    }
    m_needed.emplace(m_key, sources);
  }
  const std::int64_t spent = allowance.unitsSpent();
  for (int corner = 0; corner < 4; ++corner) {
    if (m_maps[std::size_t(corner)] || !(*m_needed)[corner])
      continue;
    if (!m_mapJob)
      m_mapJob = std::make_unique<TeMapJob>(*m_database, teMapKey(m_key, corner));
    const TeProgress progress = m_mapJob->step(allowance);
    if (progress == TeProgress::Failed)
      return fail(m_mapJob->error());
    if (progress == TeProgress::Working)
      return progress;
    m_maps[std::size_t(corner)] = m_mapJob->map();
    m_mapJob.reset();
    // A map that was found costs nothing, so that going on is the one unit that every slice does.
    if (allowance.exhausted() && allowance.unitsSpent() > spent)
      return TeProgress::Working;
  }
  return TeProgress::Done;
}

TeProgress TePatchJob::makeHeights(TeAllowance& allowance) {
  if (!m_builder) {
    TeResult<std::unique_ptr<TeHeightBuilder>> builder =
        TeHeightBuilder::create(m_maps, m_database->blendWeights());
    if (!builder)
      return fail(builder.error());
    m_builder = std::move(*builder);
  }
  if (!m_builder->step(allowance))
    return TeProgress::Working;
  const TeResult<TePatchData*> patch = m_database->lookup(m_key, TeLookup::Create);
  if (!patch)
    return fail(patch.error());
  (*patch)->setMaps(std::move(m_maps));
  (*patch)->setHeights(m_builder->take());
  m_builder.reset();
  return TeProgress::Done;
}
