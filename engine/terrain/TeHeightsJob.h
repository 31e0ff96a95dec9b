#pragma once

#include "engine/jobs/TeJob.h"
#include "engine/jobs/TeMapMaker.h"
#include "patchdb/TePatchJob.h"

/// Makes the heights of one patch: source maps, which it may share with other jobs, then their blend.
class TeHeightsJob final : public TeJob {
public:
  TeHeightsJob(TePatchDatabase& database, TeMapMaker& maps, const TePatchKey& key, TeJobKind kind,
               const TeUrgency& urgency);

  const TePatchKey& key() const { return m_job.key(); }
  TeProgress step(TeAllowance& allowance) override;
  TeJobState state() const override;
  /// Ground waits for no worker.
  bool blocked() const override { return kind() != TeJobKind::Ground && m_job.blocked(); }
  const TeError& error() const override { return m_job.error(); }

private:
  TePatchJob m_job;
};
