#pragma once

#include "apps/common/TeEngineSession.h"
#include "apps/common/TeReport.h"

/// Runs a session frame by frame without a window: tick, draw, tell the engine. Frames in which nothing has
/// changed are not drawn. In the end all jobs are finished and the final picture is drawn, with smooth edges,
/// and written if it was asked for. Adds context, frames, times and hashes to the report.
/// Error: no context, an OpenGL error, a replay that differs, a picture that cannot be written.
TeStatus teRunHeadless(TeEngineSession& session, TeReport& report);
