#pragma once

#include "apps/common/TeCommonOptions.h"
#include "apps/common/TeReport.h"
#include "nodes/TeSceneRenderer.h"

#include <memory>

/// Draws a scene without a window: frames, and pictures with smooth edges, which are kept. The scene sees to
/// its clip planes.
class TeHeadlessDrawing {
public:
  /// The scene must outlive it. Error: no such context here.
  static TeResult<TeHeadlessDrawing> create(const TeCommonOptions& common, SoNode& scene,
                                            const SbColor& background);

  /// A frame, until OpenGL is done. Error: one of OpenGL.
  TeStatus draw() { return m_frames->draw(&m_scene); }
  /// One with smooth edges. Error: one of OpenGL.
  TeResult<TePicture> picture() const;
  /// Adds context and renderer.
  void describe(TeReport& report) const;

private:
  using Renderer = std::unique_ptr<TeSceneRenderer>;

  TeHeadlessDrawing(std::unique_ptr<TeContext> context, const TeCommonOptions& common, SoNode& scene,
                    const SbColor& background)
      : m_common(common), m_scene(scene), m_background(background), m_context(std::move(context)) {}
  TeResult<Renderer> renderer(int samples) const;

  const TeCommonOptions& m_common;
  SoNode& m_scene;
  SbColor m_background;
  std::unique_ptr<TeContext> m_context;
  Renderer m_frames;
};
