#include "apps/common/TeEngineStage.h"

#include "apps/common/TeAppWorld.h"
#include "apps/common/TeHaze.h"
#include "apps/common/TeLight.h"
#include "apps/common/TeSky.h"
#include "apps/common/TeSourceGenerator.h"

namespace {

constexpr float kFieldOfView = 0.9f; ///< radians, of the shorter side
/// The haze is complete at this part of the block's half side: before the rim even where the picture's corner
/// looks at it, for OpenGL's haze counts the depth, not the distance.
constexpr double kHazeEnd = 0.85;

} // namespace

TeResult<std::unique_ptr<TeEngineStage>> TeEngineStage::create(const TeEngineOptions& options,
                                                               const TeCommonOptions& common) {
  std::unique_ptr<TeEngineStage> stage(new TeEngineStage);
  if (const TeStatus ok = stage->createEngine(options, common); !ok)
    return ok.error();
  stage->createScene(options);
  stage->setSize(common.width, common.height);
  return stage;
}

TeStatus TeEngineStage::createEngine(const TeEngineOptions& options, const TeCommonOptions& common) {
  const TeResult<TeAppWorld> made = TeAppWorld::create(options.terrain, 2 * options.radius + 1, common.seed);
  if (!made)
    return made.error();
  const TeLattice& lattice = made->world.lattice;
  m_terrain = made->description;
  m_start = made->centre + options.center;
  m_patchSide = lattice.patchSide();
  if (const TeResult<TePatchKey> key = tePatchAt(lattice, m_start); !key)
    return TeError{"--center: " + key.error().message};

  const float side = float(lattice.spacing() * (lattice.samples() - 1));
  m_engine = std::make_unique<TeEngine>(SbVec2s(short(lattice.samples()), short(lattice.samples())),
                                        SbVec2f(side, side));
  TeEngine& engine = *m_engine;
  const bool good =
      engine.isValid() && engine.setGenerator(std::make_unique<TeSourceGenerator>(made->source)) &&
      engine.setSeed(common.seed) && engine.setBlending(options.terrain.blending) &&
      engine.setRadius(options.radius) && options.apply(engine, common) && engine.setWorkers(options.workers);
  return good ? TeStatus() : TeError{engine.lastError()};
}

void TeEngineStage::createScene(const TeEngineOptions& options) {
  m_all = TeNodePtr<SoSeparator>(new SoSeparator);
  m_scene = TeNodePtr<SoSeparator>(new SoSeparator);
  m_camera = TeNodePtr<SoPerspectiveCamera>(new SoPerspectiveCamera);
  m_camera->heightAngle = kFieldOfView;
  m_all->addChild(teSky(*m_camera, m_background));
  m_all->addChild(m_scene.get());
  if (options.hazy())
    m_scene->addChild(teHaze(m_background, float(kHazeEnd * options.radius * m_patchSide)));
  m_scene->addChild(m_camera.get());
  // The sun in the west, low enough that relief shows, and the sky.
  teAddLight(*m_scene, SbVec3f(0.75f, -0.2f, -0.6f), SbColor(1.0f, 0.96f, 0.88f), 0.95f);
  teAddLight(*m_scene, SbVec3f(0, 0, -1), SbColor(0.75f, 0.87f, 1.0f), 0.35f);
  m_engine->setSceneRoot(m_scene.get());
  m_engine->setSceneCamera(m_camera.get());

  m_hud = TeNodePtr<SoSeparator>(new SoSeparator);
  m_hudCamera = TeNodePtr<SoOrthographicCamera>(new SoOrthographicCamera);
  m_hud->addChild(m_hudCamera.get());
  m_all->addChild(m_hud.get());
  m_engine->setHudRoot(m_hud.get());
  m_engine->setHudCamera(m_hudCamera.get());
  m_engine->getHud().setVisible(options.hud);
  m_engine->getHud().setProgramHelp({"F12, G  picture into a file", "Esc  quit"});
  m_engine->getCameraRig().setPerson(options.thirdPerson ? TeCameraRig::Person::Third
                                                         : TeCameraRig::Person::First);
}

void TeEngineStage::setSize(int width, int height) {
  m_camera->aspectRatio = float(width) / float(height);
  m_engine->getHud().setViewport(width, height);
}
