#pragma once

#include "apps/terrane-view/TeViewSession.h"

/// Runs a session in a window: keys, mouse, frames when something has changed; until the window is closed,
/// Esc is pressed, or so many frames as asked for were drawn. Adds context, frames, times and the picture's
/// hash to the report.
/// Error: no window, a picture that cannot be written.
TeStatus teViewWindow(TeViewSession& session, TeReport& report);
