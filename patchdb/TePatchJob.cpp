#include "patchdb/TePatchJob.h"

#include <new>

TePatchJob::TePatchJob(TePatchDatabase& database, const TePatchKey& key, TeMapProvider* provider)
    : m_database(&database), m_key(key), m_ownMaps(database), m_provider(provider ? provider : &m_ownMaps) {
  if (!key.valid())
    m_progress = fail({"outside the world"});
  else if (key.level != 0)
    m_progress = fail({"only patches of level 0 are made from source maps"});
}

TePatchJob::~TePatchJob() { releaseMaps(); }

TePatchJob::Stage TePatchJob::stage() const {
  if (m_progress != TeProgress::Working)
    return Stage::Ended;
  return m_builder ? Stage::Blend : m_needed ? Stage::SourceMaps : Stage::Waiting;
}

bool TePatchJob::blocked() const {
  if (m_hurries || stage() != Stage::SourceMaps)
    return false;
  bool lacking = false;
  for (int corner = 0; corner < 4; ++corner)
    if (m_requested[std::size_t(corner)]) {
      lacking = true;
      if (!m_provider->blocked(teMapKey(m_key, corner)))
        return false;
    }
  return lacking;
}

TeProgress TePatchJob::fail(const TeError& error) {
  releaseMaps();
  m_builder.reset();
  m_maps = {};
  m_error.message = "patch " + m_key.text() + ": " + error.message;
  return TeProgress::Failed;
}

TeProgress TePatchJob::step(TeAllowance& allowance) {
  if (m_progress != TeProgress::Working)
    return m_progress;
  const TeProgress maps = makeMaps(allowance);
  if (maps != TeProgress::Done)
    return maps;
  try {
    m_progress = makeHeights(allowance);
  } catch (const std::bad_alloc&) {
    m_progress = failWithoutMemory();
  }
  return m_progress;
}

TeProgress TePatchJob::finish() {
  TeAllowance all = TeAllowance::unlimited();
  return step(all);
}

TeProgress TePatchJob::makeMaps(TeAllowance& allowance) {
  if (m_progress == TeProgress::Failed)
    return m_progress;
  try {
    if (!m_needed)
      if (const TeStatus ok = requestMaps(); !ok)
        return m_progress = fail(ok.error());
    const TeProgress progress = provideMaps(allowance);
    if (progress == TeProgress::Failed)
      m_progress = progress;
    return progress;
  } catch (const std::bad_alloc&) {
    return m_progress = failWithoutMemory();
  }
}

/// Needs no memory itself.
TeProgress TePatchJob::failWithoutMemory() {
  releaseMaps();
  m_builder.reset();
  m_maps = {};
  m_error.message = "out of memory";
  return TeProgress::Failed;
}

TeStatus TePatchJob::requestMaps() {
  // All four sources are remembered even where one map is enough: the neighbours share the others.
  std::array<TeHeightSourcePtr, 4> sources;
  for (int corner = 0; corner < 4; ++corner) {
    const TeResult<TeHeightSourcePtr> source = m_database->mapSource(teMapKey(m_key, corner));
    if (!source)
      return source.error();
    sources[std::size_t(corner)] = *source;
  }
  m_needed.emplace(m_key, sources);
  for (int corner = 0; corner < 4; ++corner)
    if ((*m_needed)[corner]) {
      m_provider->request(teMapKey(m_key, corner));
      m_requested[std::size_t(corner)] = true;
    }
  return {};
}

void TePatchJob::releaseMap(int corner) {
  if (std::exchange(m_requested[std::size_t(corner)], false))
    m_provider->release(teMapKey(m_key, corner));
}

void TePatchJob::releaseMaps() {
  for (int corner = 0; corner < 4; ++corner)
    releaseMap(corner);
}

TeProgress TePatchJob::provideMaps(TeAllowance& allowance) {
  const std::int64_t spent = allowance.unitsSpent();
  bool all = true;
  for (int corner = 0; corner < 4; ++corner) {
    if (!m_requested[std::size_t(corner)])
      continue;
    // A map that was found costs nothing, so that going on is the one unit that every slice does.
    if (allowance.exhausted() && allowance.unitsSpent() > spent)
      return TeProgress::Working;
    if (m_hurries)
      m_provider->hurry(teMapKey(m_key, corner));
    TeError error;
    const TeProgress progress =
        m_provider->provide(teMapKey(m_key, corner), allowance, m_maps[std::size_t(corner)], error);
    if (progress == TeProgress::Failed)
      return fail(error);
    if (progress == TeProgress::Done)
      releaseMap(corner);
    else
      all = false; // being made elsewhere, or nothing is left of the allowance
  }
  if (allowance.exhausted() && allowance.unitsSpent() > spent)
    return TeProgress::Working;
  return all ? TeProgress::Done : TeProgress::Working;
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
