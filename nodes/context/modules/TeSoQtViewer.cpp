#include "nodes/TeClipPlanes.h"
#include "nodes/TePicture.h"
#include "nodes/context/TeGlTable.h"
#include "nodes/context/TeViewer.h"
#include "nodes/context/modules/TeSoQtApplication.h"

#include <Inventor/Qt/SoQt.h>
#include <Inventor/Qt/viewers/SoQtExaminerViewer.h>
#include <Inventor/events/SoKeyboardEvent.h>
#include <Inventor/sensors/SoTimerSensor.h>
#include <QOpenGLContext>
#include <QWidget>

#include <memory>

namespace {

// Without a window manager the first frame is drawn at 100×30 pixels and never again unless asked for.
constexpr double kSettleSeconds = 1.0;

class TeSoQtViewer : public SoQtExaminerViewer {
public:
  TeSoQtViewer(QWidget* parent, SoNode* scene, const TeViewerOptions& options)
      : SoQtExaminerViewer(parent), m_options(options) {
    setTitle(options.title.c_str());
    setBackgroundColor(options.background);
    setTransparencyType(SoGLRenderAction::SORTED_OBJECT_BLEND);
    setAutoClipping(FALSE);
    setDecoration(options.snapshot.empty());
    setSceneGraph(scene);
    m_settled.setInterval(kSettleSeconds);
    m_settled.setFunction([](void* viewer, SoSensor*) { static_cast<TeSoQtViewer*>(viewer)->settle(); });
    m_settled.setData(this);
    m_settled.schedule();
  }

  const TeStatus& status() const { return m_status; }

protected:
  void actualRedraw() override {
    // No camera means an empty window, as in any viewer.
    (void)teFitClipPlanes(getSceneManager()->getSceneGraph(), getViewportRegion());
    SoQtExaminerViewer::actualRedraw();
    if (m_isSettled && !m_options.snapshot.empty()) {
      m_status = writeSnapshot();
      SoQt::exitMainLoop();
    }
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
    m_settled.unschedule();
    m_isSettled = true;
    scheduleRedraw();
  }

  TeStatus writeSnapshot() const {
    QOpenGLContext* context = QOpenGLContext::currentContext();
    if (!context)
      return TeError{m_options.snapshot + ": the window has no OpenGL context"};
    const TeResult<TeGlTable> gl = TeGlTable::load(
        [&](const char* name) { return reinterpret_cast<void*>(context->getProcAddress(name)); });
    if (!gl)
      return gl.error();
    const SbVec2s size = getViewportRegion().getViewportSizePixels();
    TePicture picture;
    picture.width = size[0];
    picture.height = size[1];
    picture.rgba.resize(std::size_t(4) * picture.width * picture.height);
    gl->pixelStorei(GL_PACK_ALIGNMENT, 1);
    gl->readPixels(0, 0, picture.width, picture.height, GL_RGBA, GL_UNSIGNED_BYTE, picture.rgba.data());
    for (std::size_t alpha = 3; alpha < picture.rgba.size(); alpha += 4)
      picture.rgba[alpha] = 255;
    return picture.writePng(m_options.snapshot);
  }

  TeViewerOptions m_options;
  SoTimerSensor m_settled;
  bool m_isSettled = false;
  TeStatus m_status;
};

} // namespace

extern "C" void teRunSoQtViewer(SoNode* scene, const TeViewerOptions& options, TeStatus* status) {
  const TeResult<QWidget*> top = TeSoQtApplication::start();
  if (!top) {
    *status = top.error();
    return;
  }
  const auto viewer = std::make_unique<TeSoQtViewer>(*top, scene, options);
  (*top)->resize(options.width, options.height);
  viewer->show();
  SoQt::show(*top);
  SoQt::mainLoop();
  *status = viewer->status();
}
