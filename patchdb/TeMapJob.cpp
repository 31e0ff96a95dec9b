#include "patchdb/TeMapJob.h"

TeStatus TeMapJob::start() {
  const TeResult<TeHeightSourcePtr> source = m_database->mapSource(m_key);
  if (!source)
    return source.error();
  const int samples = m_database->lattice().samples();
  if (TeStatus ok = (*source)->accepts(samples, samples); !ok)
    return ok;
  const TeWorld& world = m_database->world();
  m_job = (*source)->start(TeMapRequest::sourceMap(world.lattice, world.seed, m_key));
  return {};
}

TeProgress TeMapJob::fail(const TeError& error) {
  m_error.message =
      "source map (" + std::to_string(m_key.x) + ", " + std::to_string(m_key.y) + "): " + error.message;
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
  if (!m_job)
    if (TeStatus ok = start(); !ok)
      return fail(ok.error());
  switch (m_job->step(allowance)) {
  case TeProgress::Working:
    return TeProgress::Working;
  case TeProgress::Failed:
    return fail(m_job->error());
  case TeProgress::Done:
    break;
  }
  TeHeightMap heights = m_job->takeMap();
  m_job.reset();
  const int samples = m_database->lattice().samples();
  if (heights.width() != samples || heights.height() != samples)
    return fail({"the source made a map of another size than asked for"});
  m_map = m_database->addMap(m_key, std::move(heights));
  return TeProgress::Done;
}
