#include "nodes/context/modules/TeSoQtFrames.h"

#include <Inventor/Qt/SoQt.h>
#include <QOpenGLContext>

#include <algorithm>

namespace {

// Without a window manager the first frame is drawn at 100×30 pixels and never again unless asked for.
constexpr double kSettleSeconds = 1.0;
constexpr int kMostTries = 10; ///< to draw the first of a number of frames

} // namespace

TeSoQtFrames::TeSoQtFrames(SoQtRenderArea& area, const TeViewerOptions& options)
    : m_area(area), m_options(options) {
  m_settled.setInterval(kSettleSeconds);
  m_settled.setFunction([](void* frames, SoSensor*) { static_cast<TeSoQtFrames*>(frames)->settle(); });
  m_settled.setData(this);
  m_settled.schedule();
}

void TeSoQtFrames::settle() {
  m_isSettled = true;
  if (m_options.frames == 0) {
    m_settled.unschedule();
    m_area.scheduleRedraw();
  } else if (m_tries++ < kMostTries) {
    if (m_session && m_session->frames == 0)
      m_area.render();
  } else if (m_session && m_session->frames == 0) {
    m_session = TeError{"the window does not become visible"};
    SoQt::exitMainLoop();
  }
}

void TeSoQtFrames::end() {
  if (!m_isSettled || !m_session)
    return;
  if (const TeStatus ok = loadGl(); !ok) {
    m_session = ok.error();
    SoQt::exitMainLoop();
    return;
  }
  m_gl.finish();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
  m_lastSeconds = seconds;
  ++m_session->frames;
  m_session->meanSeconds += (seconds - m_session->meanSeconds) / m_session->frames;
  m_session->longestSeconds = std::max(m_session->longestSeconds, seconds);
  if (m_options.frames == 0)
    return;
  if (m_session->frames < m_options.frames) {
    m_area.scheduleRedraw();
    return;
  }
  if (TeResult<TePicture> picture = readPicture())
    m_session->picture = std::move(*picture);
  else
    m_session = picture.error();
  SoQt::exitMainLoop();
}

TeStatus TeSoQtFrames::loadGl() {
  if (m_gl.finish)
    return {};
  QOpenGLContext* context = QOpenGLContext::currentContext();
  if (!context)
    return TeError{"the window has no OpenGL context"};
  const TeResult<TeGlTable> gl = TeGlTable::load(
      [&](const char* name) { return reinterpret_cast<void*>(context->getProcAddress(name)); });
  if (!gl)
    return gl.error();
  m_gl = *gl;
  m_session->renderer = reinterpret_cast<const char*>(m_gl.getString(GL_RENDERER));
  return {};
}

TeResult<TePicture> TeSoQtFrames::readPicture() {
  if (const TeStatus ok = loadGl(); !ok)
    return ok.error();
  const SbVec2s size = m_area.getViewportRegion().getViewportSizePixels();
  TePicture picture;
  picture.width = size[0];
  picture.height = size[1];
  picture.rgba.resize(std::size_t(4) * picture.width * picture.height);
  m_gl.pixelStorei(GL_PACK_ALIGNMENT, 1);
  m_gl.readPixels(0, 0, picture.width, picture.height, GL_RGBA, GL_UNSIGNED_BYTE, picture.rgba.data());
  for (std::size_t alpha = 3; alpha < picture.rgba.size(); alpha += 4)
    picture.rgba[alpha] = 255;
  return picture;
}
