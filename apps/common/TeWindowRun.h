#pragma once

#include "apps/common/TeEngineSession.h"
#include "apps/common/TeReport.h"

/// Runs a session in a window: keys, ticks by TeEngineLoop, frames when something has changed; until the
/// window is closed, Esc is pressed, a replay has ended, or so many frames as asked for were drawn. Adds
/// context, frames, times and the state's hash to the report.
/// Error: no window, a replay that differs, a picture that cannot be written.
TeStatus teRunInWindow(TeEngineSession& session, const std::string& title, TeReport& report);
