#include "engine/jobs/TeJob.h"

TeJob::~TeJob() = default;
