#pragma once

#include "generators/base/TeResult.h"

#include <Inventor/SbColor.h>

#include <string>

class SoNode;

/// How a scene is shown in a window.
struct TeViewerOptions {
  std::string title = "Terrane";
  int width = 1024;
  int height = 768;
  SbColor background{0.53f, 0.72f, 0.9f};
  /// Writes the window's contents to this PNG file once it has settled, and leaves.
  std::string snapshot;
};

/// Shows a scene in an examiner viewer until the window is closed or Q is pressed. Loads SoQt on first use.
/// The scene's own camera and lights are used; near and far planes follow the scene.
/// Error: no display, SoQt not installed, a snapshot that cannot be written.
TeStatus teRunViewer(SoNode* scene, const TeViewerOptions& options);
