#include "nodes/TeClipPlanes.h"
#include "nodes/context/TeGlTable.h"
#include "nodes/context/TeViewer.h"
#include "nodes/context/modules/TeSoQtApplication.h"

#include <Inventor/Qt/SoQt.h>
#include <Inventor/Qt/viewers/SoQtExaminerViewer.h>
#include <Inventor/actions/SoSearchAction.h>
#include <Inventor/events/SoKeyboardEvent.h>
#include <Inventor/nodes/SoLight.h>
#include <Inventor/sensors/SoTimerSensor.h>
#include <QOpenGLContext>
#include <QWidget>

#include <algorithm>
#include <chrono>

namespace {

// Without a window manager the first frame is drawn at 100×30 pixels and never again unless asked for.
constexpr double kSettleSeconds = 1.0;
constexpr int kMostTries = 10; ///< to draw the first of a number of frames

bool hasLight(SoNode* scene) {
  SoSearchAction search;
  search.setType(SoLight::getClassTypeId());
  search.apply(scene);
  return search.getPath() != nullptr;
}

class TeSoQtViewer : public SoQtExaminerViewer {
public:
  TeSoQtViewer(QWidget* parent, SoNode* scene, const TeViewerOptions& options)
      : SoQtExaminerViewer(parent), m_options(options) {
    setTitle(options.title.c_str());
    setBackgroundColor(options.background);
    setTransparencyType(SoGLRenderAction::SORTED_OBJECT_BLEND);
    setAutoClipping(FALSE);
    setDecoration(options.frames == 0);
    setSceneGraph(scene);
    setHeadlight(!hasLight(scene));
    m_settled.setInterval(kSettleSeconds);
    m_settled.setFunction([](void* viewer, SoSensor*) { static_cast<TeSoQtViewer*>(viewer)->settle(); });
    m_settled.setData(this);
    m_settled.schedule();
  }

  const TeResult<TeViewerSession>& session() const { return m_session; }

protected:
  void actualRedraw() override {
    const auto start = std::chrono::steady_clock::now();
    // No camera means an empty window, as in any viewer.
    (void)teFitClipPlanes(getSceneManager()->getSceneGraph(), getViewportRegion());
    SoQtExaminerViewer::actualRedraw();
    if (m_isSettled && m_session)
      count(start);
  }

  SbBool processSoEvent(const SoEvent* const event) override {
    if (SO_KEY_PRESS_EVENT(event, Q)) {
      SoQt::exitMainLoop();
      return TRUE;
    }
    return SoQtExaminerViewer::processSoEvent(event);
  }

private:
  void settle() {
    m_isSettled = true;
    if (m_options.frames == 0) {
      m_settled.unschedule();
      scheduleRedraw();
    } else if (m_tries++ < kMostTries) {
      if (m_session && m_session->frames == 0)
        render();
    } else if (m_session && m_session->frames == 0) {
      m_session = TeError{"the window does not become visible"};
      SoQt::exitMainLoop();
    }
  }

  /// A frame was drawn that began at `start`.
  void count(std::chrono::steady_clock::time_point start) {
    if (const TeStatus ok = finish(); !ok) {
      m_session = ok.error();
      SoQt::exitMainLoop();
      return;
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    ++m_session->frames;
    m_session->meanSeconds += (seconds - m_session->meanSeconds) / m_session->frames;
    m_session->longestSeconds = std::max(m_session->longestSeconds, seconds);
    if (m_options.frames == 0)
      return;
    if (m_session->frames < m_options.frames) {
      scheduleRedraw();
      return;
    }
    m_session->picture = readPicture();
    SoQt::exitMainLoop();
  }

  /// Waits for OpenGL, whose functions are asked for at the first call.
  TeStatus finish() {
    QOpenGLContext* context = QOpenGLContext::currentContext();
    if (!context)
      return TeError{"the window has no OpenGL context"};
    if (!m_gl.finish) {
      const TeResult<TeGlTable> gl = TeGlTable::load(
          [&](const char* name) { return reinterpret_cast<void*>(context->getProcAddress(name)); });
      if (!gl)
        return gl.error();
      m_gl = *gl;
      m_session->renderer = reinterpret_cast<const char*>(m_gl.getString(GL_RENDERER));
    }
    m_gl.finish();
    return {};
  }

  TePicture readPicture() const {
    const SbVec2s size = getViewportRegion().getViewportSizePixels();
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

  TeViewerOptions m_options;
  SoTimerSensor m_settled;
  bool m_isSettled = false;
  int m_tries = 0;
  TeGlTable m_gl;
  TeResult<TeViewerSession> m_session = TeViewerSession();
};

} // namespace

extern "C" void teRunSoQtViewer(SoNode* scene, const TeViewerOptions& options,
                                TeResult<TeViewerSession>* session) {
  if (const TeResult<QWidget*> top = TeSoQtApplication::start(); !top) {
    *session = top.error();
    return;
  }
  QWidget window;
  window.resize(options.width, options.height);
  window.setWindowTitle(options.title.c_str());
  TeSoQtViewer viewer(&window, scene, options);
  viewer.setSize(SbVec2s(short(options.width), short(options.height)));
  viewer.show();
  SoQt::show(&window);
  SoQt::mainLoop(); // until the last window is closed, too
  *session = viewer.session();
}
