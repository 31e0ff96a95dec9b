#pragma once

#include "nodes/TeNodePtr.h"
#include "nodes/TeSceneRenderer.h"
#include "nodes/lod/TePerspectiveView.h"

#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoSeparator.h>

#include <memory>

/// Where terrains are drawn to see how long that takes: a context, a camera, a sun.
class TeFlightStage {
public:
  /// Error: no such context here.
  static TeResult<std::unique_ptr<TeFlightStage>> create(TeContextKind kind, int width, int height);

  /// What is drawn from now on.
  void show(SoNode* terrain);
  /// Milliseconds until a frame is drawn wholly (glFinish). Error: one of OpenGL.
  TeResult<double> draw(const TePerspectiveView& view);
  /// The same, to look at.
  TeResult<TePicture> picture(const TePerspectiveView& view);

  TeContext& context() const { return *m_context; }

private:
  TeFlightStage(std::unique_ptr<TeContext> context, std::unique_ptr<TeSceneRenderer> renderer);
  void lookFrom(const TePerspectiveView& view);

  std::unique_ptr<TeContext> m_context;
  std::unique_ptr<TeSceneRenderer> m_renderer;
  TeNodePtr<SoSeparator> m_scene;
  SoPerspectiveCamera* m_camera;
};
