#pragma once

#include "apps/common/TeEngineSession.h"
#include "apps/common/TeReport.h"
#include "nodes/context/TeWindow.h"

/// Runs a session in a window: keys, ticks by TeEngineLoop, frames when something has changed; until the
/// window is closed, Esc is pressed, a replay has ended, or so many frames as asked for were drawn. Adds
/// context, frames, times and the state's hash to the report.
/// Error: no window, a replay that differs, a picture that cannot be written.
TeStatus teRunInWindow(TeEngineSession& session, const std::string& title, TeReport& report);
/// Shows a scene in a window of the size, and for the frames, that the options say. Adds context and renderer
/// to the report. Errors as for teRunWindow().
TeResult<TeViewerSession> teShowInWindow(SoNode& scene, const std::string& title, const SbColor& background,
                                         const TeCommonOptions& common, TeWindowClient& client,
                                         TeReport& report);
