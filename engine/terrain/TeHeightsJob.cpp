#include "engine/terrain/TeHeightsJob.h"

TeHeightsJob::TeHeightsJob(TePatchDatabase& database, TeMapMaker& maps, const TePatchKey& key, TeJobKind kind,
                           const TeUrgency& urgency)
    : TeJob(kind, urgency), m_job(database, key, &maps) {}

TeProgress TeHeightsJob::step(TeAllowance& allowance) {
  if (kind() == TeJobKind::Ground)
    m_job.hurry();
  return m_job.step(allowance);
}

TeJobState TeHeightsJob::state() const {
  if (m_job.progress() == TeProgress::Failed)
    return TeJobState::Failed;
  switch (m_job.stage()) {
  case TePatchJob::Stage::Waiting:
    return TeJobState::Waiting;
  case TePatchJob::Stage::SourceMaps:
    return TeJobState::SourceMaps;
  case TePatchJob::Stage::Blend:
    return TeJobState::Blend;
  case TePatchJob::Stage::Ended:
    break;
  }
  return TeJobState::Inserted;
}
