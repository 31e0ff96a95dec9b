#pragma once

#include "engine/jobs/TeWorkerTask.h"
#include "generators/TeHeightSource.h"

/// Makes one source map on a worker, unit by unit, so that it notices soon when it is cancelled.
class TeMapTask final : public TeWorkerTask {
public:
  explicit TeMapTask(std::unique_ptr<TeHeightJob> job) : m_job(std::move(job)) {}
  /// Once ended().
  TeHeightJob& job() { return *m_job; }

protected:
  TeStatus run() override;

private:
  std::unique_ptr<TeHeightJob> m_job;
};
