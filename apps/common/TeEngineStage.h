#pragma once

#include "apps/common/TeEngineOptions.h"
#include "nodes/TeNodePtr.h"

#include <Inventor/SbColor.h>
#include <Inventor/nodes/SoOrthographicCamera.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoSeparator.h>

#include <memory>
#include <string>

/// The engine of an application with its scene: sky, sun, haze, cameras, and the world that the options ask
/// for. Objects are still missing.
class TeEngineStage {
public:
  /// Error: whatever is wrong with the options. After TeNodes::init().
  static TeResult<std::unique_ptr<TeEngineStage>> create(const TeEngineOptions& options,
                                                         const TeCommonOptions& common);

  TeEngine& engine() { return *m_engine; }
  /// What is given to the engine: the world.
  SoSeparator& scene() { return *m_scene; }
  /// What is drawn: sky, scene, HUD.
  SoSeparator& all() { return *m_all; }
  const SbColor& background() const { return m_background; }
  glm::dvec2 start() const { return m_start; }
  const std::string& terrain() const { return m_terrain; }
  double patchSide() const { return m_patchSide; }

  /// Of the picture, pixels.
  void setSize(int width, int height);

private:
  TeEngineStage() = default;
  TeStatus createEngine(const TeEngineOptions& options, const TeCommonOptions& common);
  void createScene(const TeEngineOptions& options);

  std::string m_terrain;
  glm::dvec2 m_start{0};
  double m_patchSide = 0;
  SbColor m_background{0.62f, 0.75f, 0.88f};
  TeNodePtr<SoSeparator> m_all;
  TeNodePtr<SoSeparator> m_scene;
  TeNodePtr<SoSeparator> m_hud;
  TeNodePtr<SoPerspectiveCamera> m_camera;
  TeNodePtr<SoOrthographicCamera> m_hudCamera;
  std::unique_ptr<TeEngine> m_engine;
};
