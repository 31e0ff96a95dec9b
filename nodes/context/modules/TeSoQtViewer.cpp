#include "nodes/TeClipPlanes.h"
#include "nodes/context/TeViewer.h"
#include "nodes/context/modules/TeSoQtApplication.h"
#include "nodes/context/modules/TeSoQtFrames.h"

#include <Inventor/Qt/SoQt.h>
#include <Inventor/Qt/viewers/SoQtExaminerViewer.h>
#include <Inventor/actions/SoSearchAction.h>
#include <Inventor/events/SoKeyboardEvent.h>
#include <Inventor/nodes/SoLight.h>
#include <QWidget>

namespace {

bool hasLight(SoNode* scene) {
  SoSearchAction search;
  search.setType(SoLight::getClassTypeId());
  search.apply(scene);
  return search.getPath() != nullptr;
}

class TeSoQtViewer : public SoQtExaminerViewer {
public:
  TeSoQtViewer(QWidget* parent, SoNode* scene, const TeViewerOptions& options)
      : SoQtExaminerViewer(parent), m_frames(*this, options) {
    setTitle(options.title.c_str());
    setBackgroundColor(options.background);
    setTransparencyType(SoGLRenderAction::SORTED_OBJECT_BLEND);
    setAutoClipping(FALSE);
    setDecoration(options.frames == 0);
    setSceneGraph(scene);
    setHeadlight(!hasLight(scene));
  }

  const TeResult<TeViewerSession>& session() const { return m_frames.session(); }

protected:
  void actualRedraw() override {
    m_frames.begin();
    // No camera means an empty window, as in any viewer.
    (void)teFitClipPlanes(getSceneManager()->getSceneGraph(), getViewportRegion());
    SoQtExaminerViewer::actualRedraw();
    m_frames.end();
  }

  SbBool processSoEvent(const SoEvent* const event) override {
    if (SO_KEY_PRESS_EVENT(event, Q)) {
      SoQt::exitMainLoop();
      return TRUE;
    }
    return SoQtExaminerViewer::processSoEvent(event);
  }

private:
  TeSoQtFrames m_frames;
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
