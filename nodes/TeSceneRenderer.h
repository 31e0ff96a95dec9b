#pragma once

#include "nodes/TePicture.h"
#include "nodes/context/TeContext.h"

#include <Inventor/SbColor.h>
#include <Inventor/actions/SoGLRenderAction.h>

#include <memory>

class SoNode;

/// Draws Coin scenes into pictures, in a framebuffer of its own, in any context.
///
/// The renderer must be destroyed before its context. Everything happens on the context's thread.
class TeSceneRenderer {
public:
  /// `samples` per pixel smooth the edges (1 = none); as many as OpenGL allows are taken. Error: a size out
  /// of range, a framebuffer that OpenGL refuses.
  static TeResult<std::unique_ptr<TeSceneRenderer>> create(TeContext& context, int width, int height,
                                                           int samples = 1);
  ~TeSceneRenderer();
  TeSceneRenderer(const TeSceneRenderer&) = delete;
  TeSceneRenderer& operator=(const TeSceneRenderer&) = delete;

  void setBackground(const SbColor& colour) { m_background = colour; }
  /// For settings such as the kind of transparency.
  SoGLRenderAction& action() { return m_action; }

  /// Whether draw() sets near and far planes of the scene's first camera from the scene's bounding box
  /// (teFitClipPlanes); by default it does. Scenes that go on beyond what is loaded, or have several cameras,
  /// set their planes themselves.
  void setFitClipPlanes(bool fit) { m_fitsClipPlanes = fit; }

  /// Draws one frame. Error: no camera in the scene whose planes are to be fitted, an OpenGL error while
  /// drawing.
  TeStatus draw(SoNode* scene);
  /// Draws one frame and reads it; alpha is 255 everywhere.
  TeResult<TePicture> render(SoNode* scene);

private:
  /// A framebuffer with colour and depth.
  struct Target {
    GLuint framebuffer = 0;
    GLuint colour = 0;
    GLuint depth = 0;
  };

  TeSceneRenderer(TeContext& context, int width, int height);
  TeResult<TePicture> read();
  TeStatus createTarget(Target& target, int samples);
  void destroyTarget(Target& target);

  TeContext& m_context;
  int m_width;
  int m_height;
  SbColor m_background{0.53f, 0.72f, 0.9f};
  bool m_fitsClipPlanes = true;
  SoGLRenderAction m_action;
  Target m_target;
  Target m_resolved; ///< of one sample; only if m_target has more
};
