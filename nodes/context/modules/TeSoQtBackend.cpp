#include "nodes/context/TeContextBackend.h"
#include "nodes/context/modules/TeSoQtApplication.h"

#include <Inventor/Qt/SoQtRenderArea.h>
#include <QApplication>
#include <QOpenGLContext>
#include <QWidget>

#include <memory>

namespace {

/// A window whose contents the owner of the context draws.
class TeSoQtArea : public SoQtRenderArea {
public:
  explicit TeSoQtArea(QWidget* parent) : SoQtRenderArea(parent, "Terrane", TRUE, FALSE, FALSE) {
    setAutoRedraw(FALSE);
  }
  void makeCurrent() { glLockNormal(); }
  void swap() { glSwapBuffers(); }

protected:
  void redraw() override {}
};

class TeSoQtBackend : public TeContextBackend {
public:
  TeSoQtBackend(int width, int height) : m_window(std::make_unique<QWidget>()) {
    m_window->resize(width, height);
    m_area = std::make_unique<TeSoQtArea>(m_window.get());
    m_area->setSize(SbVec2s(short(width), short(height)));
    m_area->show();
    m_window->show();
    QApplication::processEvents();
  }

  TeStatus makeCurrent() override {
    m_area->makeCurrent();
    if (!QOpenGLContext::currentContext())
      return TeError{"the window has no OpenGL context"};
    return {};
  }

  void* procAddress(const char* name) const override {
    QOpenGLContext* context = QOpenGLContext::currentContext();
    return context ? reinterpret_cast<void*>(context->getProcAddress(name)) : nullptr;
  }

  void present() override {
    m_area->swap();
    QApplication::processEvents();
  }

private:
  std::unique_ptr<QWidget> m_window;
  std::unique_ptr<TeSoQtArea> m_area; ///< before its window
};

} // namespace

extern "C" void teCreateContext(int width, int height, TeResult<TeContextBackendPtr>* result) {
  if (const TeResult<QWidget*> top = TeSoQtApplication::start(); !top) {
    *result = top.error();
    return;
  }
  auto backend = std::make_unique<TeSoQtBackend>(width, height);
  if (TeStatus status = backend->makeCurrent(); !status) {
    *result = status.error();
    return;
  }
  *result = TeContextBackendPtr(std::move(backend));
}
