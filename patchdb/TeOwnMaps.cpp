#include "patchdb/TeOwnMaps.h"

TeProgress TeOwnMaps::provide(TeMapKey key, TeAllowance& allowance, TeSourceMapPtr& map, TeError& error) {
  if (!m_job || m_job->key() != key)
    m_job.emplace(*m_database, key);
  const TeProgress progress = m_job->step(allowance);
  if (progress == TeProgress::Done)
    map = m_job->map();
  else if (progress == TeProgress::Failed)
    error = m_job->error();
  if (progress != TeProgress::Working)
    m_job.reset();
  return progress;
}
