#pragma once

#include "apps/terrane-view/TeViewSession.h"

/// Draws a session frame by frame without a window. In the end uploads that wait are awaited, and the last
/// frame is drawn again with smooth edges and written if it was asked for. Adds context, frames, times and
/// the picture's hash to the report.
/// Error: no context, an OpenGL error, a picture that cannot be written.
TeStatus teViewHeadless(TeViewSession& session, TeReport& report);
