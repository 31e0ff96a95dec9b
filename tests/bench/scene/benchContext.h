#pragma once

#include "nodes/context/TeContext.h"

/// What the benchmarks of scene-bench draw in.
inline TeContext* benchContext = nullptr;
