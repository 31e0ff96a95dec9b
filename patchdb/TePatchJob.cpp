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
  m_blend.reset();
  return TeProgress::Failed;
}

TeProgress TePatchJob::step(TeAllowance& allowance) {
  if (m_progress == TeProgress::Working)
    m_progress = makeMaps(allowance);
  return m_progress;
}

TeProgress TePatchJob::finish() {
  TeAllowance all = TeAllowance::unlimited();
  return step(all);
}

TeProgress TePatchJob::makeMaps(TeAllowance& allowance) {
  for (int corner = 0; corner < 4; ++corner) {
    if (m_maps[std::size_t(corner)])
      continue;
    if (!m_mapJob)
      m_mapJob = std::make_unique<TeMapJob>(*m_database, mapKey(m_key, corner));
    const TeProgress progress = m_mapJob->step(allowance);
    if (progress == TeProgress::Failed)
      return fail(m_mapJob->error());
    if (progress == TeProgress::Working)
      return progress;
    m_maps[std::size_t(corner)] = m_mapJob->map();
    m_mapJob.reset();
    if (allowance.exhausted())
      return TeProgress::Working;
  }
  return makeHeights(allowance);
}

TeProgress TePatchJob::makeHeights(TeAllowance& allowance) {
  if (!m_blend) {
    const int side = m_database->lattice().cells() + 1;
    TeResult<TeHeightMap> heights = TeHeightMap::create(side, side);
    if (!heights)
      return fail(heights.error());
    m_heights = std::move(*heights);
    m_blend = std::make_unique<TeFourMapBlend>(m_maps[0]->heights, m_maps[1]->heights, m_maps[2]->heights,
                                               m_maps[3]->heights, m_heights);
  }
  if (!m_blend->step(allowance))
    return TeProgress::Working;
  m_blend.reset();
  const TeResult<TePatchData*> patch = m_database->lookup(m_key, TeLookup::Create);
  if (!patch)
    return fail(patch.error());
  (*patch)->setMaps(std::move(m_maps));
  (*patch)->setHeights(std::move(m_heights));
  return TeProgress::Done;
}
