#pragma once

#include "nodes/context/TeGlTable.h"
#include "nodes/context/TeViewer.h"

#include <Inventor/Qt/SoQtRenderArea.h>
#include <Inventor/sensors/SoTimerSensor.h>

#include <chrono>

/// The frames of one window: sees to it that they are drawn at the window's true size, measures them, ends
/// SoQt's main loop after as many as were asked for.
class TeSoQtFrames {
public:
  /// The area outlives this object.
  TeSoQtFrames(SoQtRenderArea& area, const TeViewerOptions& options);

  /// Around the drawing of a frame.
  void begin() { m_start = std::chrono::steady_clock::now(); }
  void end();

  /// Of the wall clock, from begin() until OpenGL was done; 0 before the window has settled.
  double lastSeconds() const { return m_lastSeconds; }
  const TeResult<TeViewerSession>& session() const { return m_session; }
  /// What was drawn; while the context is current.
  TeResult<TePicture> readPicture();

private:
  void settle();
  /// Asks for OpenGL's functions at the first call.
  TeStatus loadGl();

  SoQtRenderArea& m_area;
  TeViewerOptions m_options;
  SoTimerSensor m_settled;
  bool m_isSettled = false;
  int m_tries = 0;
  std::chrono::steady_clock::time_point m_start;
  double m_lastSeconds = 0;
  TeGlTable m_gl;
  TeResult<TeViewerSession> m_session = TeViewerSession();
};
