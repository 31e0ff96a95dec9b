#include "engine/jobs/TeWorkerTask.h"

#include <new>

TeWorkerTask::~TeWorkerTask() = default;

void TeWorkerTask::runToEnd() {
  try {
    if (!cancelled())
      m_status = run();
  } catch (const std::bad_alloc&) {
    m_status = TeError{"out of memory"}; // short enough to need none
  }
}
