#include "generators/base/TeAllowance.h"
#include "nodes/context/TeWindow.h"
#include "nodes/context/modules/TeSoQtApplication.h"
#include "nodes/context/modules/TeSoQtFrames.h"

#include <Inventor/Qt/SoQt.h>
#include <QKeyEvent>
#include <QOpenGLContext>
#include <QWidget>

#include <utility>

namespace {

class TeSoQtWindow : public SoQtRenderArea, public TeWindow {
public:
  TeSoQtWindow(QWidget* parent, SoNode* scene, const TeViewerOptions& options, TeWindowClient& client)
      : SoQtRenderArea(parent, options.title.c_str()), m_client(client), m_frames(*this, options) {
    setBackgroundColor(options.background);
    setTransparencyType(SoGLRenderAction::SORTED_OBJECT_BLEND);
    setSceneGraph(scene);
    m_client.opened(*this);
    m_client.resized(options.width, options.height);
  }

  const TeResult<TeViewerSession>& session() const { return m_frames.session(); }

  void takeFocus() {
    getGLWidget()->setFocusPolicy(Qt::StrongFocus);
    getGLWidget()->setFocus();
  }

  void close() override { SoQt::exitMainLoop(); }
  void capture(std::function<void(const TeResult<TePicture>&)> taken) override {
    m_taken = std::move(taken);
    scheduleRedraw();
  }

protected:
  void actualRedraw() override {
    m_frames.begin();
    const double before = teThreadCpuSeconds();
    SoQtRenderArea::actualRedraw();
    const double drawSeconds = teThreadCpuSeconds() - before;
    if (m_taken)
      std::exchange(m_taken, nullptr)(m_frames.readPicture());
    m_frames.end();
    const auto now = std::chrono::steady_clock::now();
    const double frameSeconds = m_drawn ? std::chrono::duration<double>(now - m_last).count() : 0;
    m_last = now;
    m_drawn = true;
    m_client.drawn(frameSeconds, drawSeconds, m_frames.lastSeconds());
  }

  void processEvent(QEvent* event) override {
    const bool key = event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease;
    if (key && static_cast<QKeyEvent*>(event)->isAutoRepeat())
      return;
    if (event->type() == QEvent::FocusOut)
      m_client.keysLost();
    SoQtRenderArea::processEvent(event);
  }

  void sizeChanged(const SbVec2s& size) override {
    SoQtRenderArea::sizeChanged(size);
    const SbVec2s pixels = getViewportRegion().getViewportSizePixels();
    m_client.resized(pixels[0], pixels[1]);
  }

private:
  TeWindowClient& m_client;
  TeSoQtFrames m_frames;
  std::function<void(const TeResult<TePicture>&)> m_taken;
  bool m_drawn = false;
  std::chrono::steady_clock::time_point m_last;
};

} // namespace

extern "C" void teRunSoQtWindow(SoNode* scene, const TeViewerOptions& options, TeWindowClient& client,
                                TeResult<TeViewerSession>* session) {
  if (const TeResult<QWidget*> top = TeSoQtApplication::start(); !top) {
    *session = top.error();
    return;
  }
  QWidget parent;
  parent.resize(options.width, options.height);
  parent.setWindowTitle(options.title.c_str());
  TeSoQtWindow window(&parent, scene, options, client);
  window.setSize(SbVec2s(short(options.width), short(options.height)));
  window.show();
  SoQt::show(&parent);
  window.takeFocus();
  SoQt::mainLoop(); // until the last window is closed, too
  *session = window.session();
}
