#pragma once

#include "generators/base/TeResult.h"
#include "nodes/TePicture.h"

#include <Inventor/SbColor.h>

#include <string>

class SoNode;

/// How a scene is shown in a window.
struct TeViewerOptions {
  std::string title = "Terrane";
  int width = 1024;
  int height = 768;
  SbColor background{0.53f, 0.72f, 0.9f};
  /// Once the window has settled, draws so many frames and leaves; 0 = shows it until it is closed.
  int frames = 0;
};

/// What happened in a window.
struct TeViewerSession {
  int frames = 0;         ///< drawn since the window had settled
  double meanSeconds = 0; ///< to draw one of them
  double longestSeconds = 0;
  std::string renderer; ///< GL_RENDERER
  TePicture picture;    ///< the last frame, if a number of frames was asked for
};

/// Shows a scene in an examiner viewer until the window is closed or Q is pressed, or for a number of frames.
/// Loads SoQt on first use. The scene's own camera and lights are used, a headlight only if it has no light;
/// near and far planes follow the scene.
/// Error: no display, SoQt not installed, a window without OpenGL, a window that never becomes visible when a
/// number of frames is asked for.
TeResult<TeViewerSession> teRunViewer(SoNode* scene, const TeViewerOptions& options);
