#pragma once

#include "nodes/context/TeViewer.h"

#include <functional>

/// A window on the display that shows a scene as it is: with the scene's own cameras, without any control of
/// its own. Exists while teRunWindow() runs.
class TeWindow {
public:
  virtual ~TeWindow();
  TeWindow(const TeWindow&) = delete;
  TeWindow& operator=(const TeWindow&) = delete;

  /// Makes teRunWindow() return.
  virtual void close() = 0;
  /// Draws again and gives the picture, with opaque pixels. Error: no OpenGL.
  virtual void capture(std::function<void(const TeResult<TePicture>&)> taken) = 0;

protected:
  TeWindow() = default;
};

/// Who shows something in a TeWindow.
class TeWindowClient {
public:
  virtual ~TeWindowClient();

  /// Before the first frame; the window exists until teRunWindow() returns.
  virtual void opened(TeWindow& /*window*/) {}
  /// Pixels; also before the first frame.
  virtual void resized(int /*width*/, int /*height*/) {}
  /// A frame was drawn: seconds of the wall clock since the frame before (0 for the first), of this thread's
  /// CPU time for drawing it, and of the wall clock until OpenGL was done with it (0 for frames before the
  /// window has settled).
  virtual void drawn(double /*frameSeconds*/, double /*drawSeconds*/, double /*finishSeconds*/) {}
  /// The window lost the keyboard: keys that are held will not be heard to go up.
  virtual void keysLost() {}
};

/// Shows a scene in a window until it is closed, or for a number of frames, which are drawn one after the
/// other. Else it is drawn when it changes. Keys and mouse reach its event nodes; repetitions of a held key
/// are left out. Loads SoQt on first use. Errors as for teRunViewer().
TeResult<TeViewerSession> teRunWindow(SoNode* scene, const TeViewerOptions& options, TeWindowClient& client);
