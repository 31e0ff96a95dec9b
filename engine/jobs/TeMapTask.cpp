#include "engine/jobs/TeMapTask.h"

TeStatus TeMapTask::run() {
  while (!cancelled()) {
    TeAllowance unit = TeAllowance::units(1);
    if (m_job->step(unit) != TeProgress::Working)
      break;
  }
  return {};
}
