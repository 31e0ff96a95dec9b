#include "engine/TeEngine.h"

#include "engine/TeEngineRuntime.h"
#include "generators/TeGeneratorRegistry.h"
#include "generators/base/TeHash.h"
#include "generators/base/TeLog.h"

#include <Inventor/SoDB.h>
#include <Inventor/actions/SoSearchAction.h>

#include <cmath>
#include <utility>

namespace {

TeResult<TeLattice> latticeOf(const SbVec2s& samples, const SbVec2f& area) {
  const std::string given = std::to_string(samples[0]) + "×" + std::to_string(samples[1]);
  if (samples[0] != samples[1])
    return TeError{"TeEngine: source maps of " + given + " samples: both sides must be equal"};
  if (!(area[0] == area[1]))
    return TeError{"TeEngine: area of " + std::to_string(area[0]) + " by " + std::to_string(area[1]) +
                   " m: both sides must be equal numbers"};
  if (samples[0] < TeLattice::kMinSamples)
    return TeError{"TeEngine: source maps of " + given + " samples: at least " +
                   std::to_string(TeLattice::kMinSamples) + " a side"};
  return TeLattice::create(samples[0], double(area[0]) / (samples[0] - 1));
}

bool isBelow(SoNode* root, SoNode* node) {
  SoSearchAction search;
  search.setNode(node);
  search.setSearchingAll(TRUE);
  search.apply(root);
  return search.getPath() != nullptr;
}

} // namespace

TeEngine::TeEngine(const SbVec2s& samples, const SbVec2f& area) {
  const TeResult<TeLattice> lattice = latticeOf(samples, area);
  if (!lattice) {
    fail(lattice.error());
    return;
  }
  m_lattice = *lattice;
  m_usable = true;
  setGenerator(TeGeneratorRegistry::kDefaultGenerator);
}

TeEngine::~TeEngine() = default;

SbBool TeEngine::fail(const TeError& error) {
  m_lastError = error.message;
  TeLog::error(error.message);
  return FALSE;
}

SbBool TeEngine::setSeed(std::uint64_t seed) {
  if (!m_patches.empty() || m_runtime)
    return fail({"TeEngine: the seed cannot change once there are patches"});
  m_seed = seed;
  return isValid() ? createDatabase() : FALSE;
}

SbBool TeEngine::setBlending(TeBlendProfile profile) {
  if (!m_patches.empty() || m_runtime)
    return fail({"TeEngine: the blending cannot change once there are patches"});
  m_blending = profile;
  return isValid() ? createDatabase() : FALSE;
}

SbBool TeEngine::setGenerator(const std::string& specification, const std::vector<std::string>& filters) {
  TeResult<std::unique_ptr<TeGenerator>> made = TeGeneratorRegistry::instance().chain(specification, filters);
  return made ? setGenerator(std::move(*made)) : fail(made.error());
}

SbBool TeEngine::setGenerator(std::unique_ptr<TeGenerator> generator) {
  if (!m_usable)
    return FALSE;
  if (!generator)
    return fail({"TeEngine: no generator given"});
  if (const TeStatus ok = generator->updateParams(); !ok)
    return fail(ok.error());
  if (const TeStatus ok = generator->source()->accepts(m_lattice.samples(), m_lattice.samples()); !ok)
    return fail(ok.error());
  m_generator = std::move(generator);
  m_paramsOfTick.reset();
  return m_database ? updateParams() : createDatabase();
}

SbBool TeEngine::updateParams() {
  const TeStatus ok = takeParams();
  return ok ? TRUE : fail(ok.error());
}

TeStatus TeEngine::takeParams() {
  if (const TeStatus ok = m_generator->updateParams(); !ok)
    return ok;
  const TeHeightSourcePtr source = m_generator->source();
  if (source->fingerprint() == m_source->fingerprint())
    return {};
  if (const TeStatus ok = m_database->setSources(std::make_shared<TeSingleSource>(source)); !ok)
    return ok;
  m_source = source;
  return {};
}

void TeEngine::takeParamsForTick() {
  // To make a source may be work: one of elevation data opens its file.
  const TeParameters parameters = m_generator->parameters();
  const std::uint64_t hash = teHashParameters(parameters, 0);
  if (!parameters.empty() && m_paramsOfTick == hash)
    return;
  m_paramsOfTick = hash;
  const TeStatus ok = takeParams();
  const std::string fault = ok ? "" : ok.error().message;
  if (fault == std::exchange(m_paramsFault, fault) || ok)
    return;
  fail(ok.error());
  if (const ErrorCallback callback = m_settings.error)
    callback(fault);
}

SbBool TeEngine::createDatabase() {
  m_source = m_generator->source();
  auto made =
      TePatchDatabase::create({m_lattice, m_seed, std::make_shared<TeSingleSource>(m_source), m_blending});
  if (!made)
    return fail(made.error());
  m_database = std::move(*made);
  return TRUE;
}

TePatch* TeEngine::getPatch(const SbVec2f& point) { return getPatch(SbVec2d(point[0], point[1])); }

TePatch* TeEngine::getPatch(const SbVec2d& point) {
  if (!isValid())
    return nullptr;
  const TeResult<TePatchKey> key = tePatchAt(m_lattice, {point[0], point[1]});
  if (!key) {
    fail(key.error());
    return nullptr;
  }
  return getPatch(*key);
}

TePatch* TeEngine::getPatch(const TePatchKey& key) {
  if (!isValid())
    return nullptr;
  if (const auto found = m_patches.find(key); found != m_patches.end())
    return found->second.get();
  if (key.level != 0) {
    fail({"patch " + key.text() + ": TeEngine makes patches of level 0"});
    return nullptr;
  }
  const TeResult<TePatchData*> data = m_database->lookup(key, TeLookup::Create);
  if (!data) {
    fail(data.error());
    return nullptr;
  }
  return m_patches.emplace(key, std::unique_ptr<TePatch>(new TePatch(*this, **data))).first->second.get();
}

SbBool TeEngine::setOrigin(const SbVec2d& point) {
  if (!std::isfinite(point[0]) || !std::isfinite(point[1]))
    return fail({"TeEngine: the origin must be finite"});
  m_origin = point;
  if (m_graphs)
    m_graphs->setWorldOrigin({point[0], point[1], 0});
  return TRUE;
}

TePatchGraphBuilder* TeEngine::getGraphBuilder() {
  if (!isValid())
    return nullptr;
  if (!SoDB::isInitialized()) {
    fail({"TeEngine: SoDB::init() has to come before graphs are made"});
    return nullptr;
  }
  if (!m_graphs)
    m_graphs = std::make_unique<TePatchGraphBuilder>(glm::dvec2(m_origin[0], m_origin[1]));
  return m_graphs.get();
}

TeNodePtr<SoSeparator> TeEngine::makeGraph(const TePatchMesh& mesh) {
  TePatchGraphBuilder* builder = getGraphBuilder();
  return builder ? builder->build(mesh) : nullptr;
}

SbBool TeEngine::checkSetting(bool good, const std::string& setting) {
  return good ? TRUE : fail({"TeEngine: " + setting});
}

SbBool TeEngine::checkEarly(const std::string& setting) {
  return checkSetting(!m_runtime, setting + " cannot change once the engine is initialised");
}

template <class Node> SbBool TeEngine::setNode(TeNodePtr<Node>& setting, Node* node, const char* what) {
  if (!checkEarly(what))
    return FALSE;
  setting = TeNodePtr<Node>(node);
  return TRUE;
}

SbBool TeEngine::setSceneRoot(SoSeparator* root) {
  return setNode(m_settings.sceneRoot, root, "the scene root");
}

SbBool TeEngine::setSceneCamera(SoPerspectiveCamera* camera) {
  return setNode(m_settings.sceneCamera, camera, "the scene camera");
}

SbBool TeEngine::setHudRoot(SoSeparator* root) { return setNode(m_settings.hudRoot, root, "the HUD root"); }

SbBool TeEngine::setHudCamera(SoOrthographicCamera* camera) {
  return setNode(m_settings.hudCamera, camera, "the HUD camera");
}

TeObject* TeEngine::addObject(std::unique_ptr<TeObject> object) {
  const TeResult<TeObject*> added = m_objects.add(std::move(object));
  if (!added) {
    fail(added.error());
    return nullptr;
  }
  if (m_runtime)
    m_runtime->addObject(**added);
  return *added;
}

SbBool TeEngine::removeObject(TeObject* object) {
  if (object && object == m_settings.active && m_runtime)
    return fail({"TeEngine: object " + object->name() + " is the active one; make another one active first"});
  if (!m_objects.contains(object))
    return fail({"TeEngine: the object to be removed is not one of the engine's"});
  if (object == m_settings.active)
    m_settings.active = nullptr;
  if (m_runtime)
    m_runtime->removeObject(*object);
  return m_objects.remove(object);
}

SbBool TeEngine::setActiveObject(TeObject* object) {
  if (!m_objects.contains(object))
    return fail({"TeEngine: the active object has to be one of the engine's"});
  if (m_settings.active && m_settings.active != object)
    m_settings.active->releaseKeys();
  m_settings.active = object;
  object->wake();
  return TRUE;
}

SbBool TeEngine::setRadius(int radius) {
  if (!checkSetting(radius >= 1 && radius <= kMaxRadius,
                    "radius " + std::to_string(radius) + " is not 1 to " + std::to_string(kMaxRadius)))
    return FALSE;
  m_settings.radius = radius;
  if (m_runtime)
    m_runtime->setRadius(radius);
  return TRUE;
}

SbBool TeEngine::setBudget(double seconds) {
  const TeStatus ok = m_settings.budget.setBudget(seconds);
  return ok ? TRUE : fail({"TeEngine: " + ok.error().message});
}

SbBool TeEngine::setFrameRate(double framesPerSecond) {
  const TeStatus ok = m_settings.budget.setFrameRate(framesPerSecond);
  return ok ? TRUE : fail({"TeEngine: " + ok.error().message});
}

SbBool TeEngine::setPixelError(double pixels) {
  if (!checkSetting(pixels >= 0 && pixels <= kMostPixelError, "a pixel error of " + std::to_string(pixels) +
                                                                  " is not 0 to " +
                                                                  std::to_string(kMostPixelError)))
    return FALSE;
  m_settings.pixelError = pixels;
  if (m_runtime)
    m_runtime->updatePixelError();
  return TRUE;
}

SbBool TeEngine::setQualityGoal(double framesPerSecond) {
  if (!checkSetting(framesPerSecond == 0 || (framesPerSecond >= TeFrameBudget::kLowestRate &&
                                             framesPerSecond <= TeFrameBudget::kHighestRate),
                    "a quality goal of " + std::to_string(framesPerSecond) +
                        " frames a second is neither 0 nor 1 to 1000"))
    return FALSE;
  const TeStatus ok = m_settings.quality.setGoal(framesPerSecond > 0 ? kDrawingShare / framesPerSecond : 0);
  if (!ok)
    return fail({"TeEngine: " + ok.error().message});
  m_settings.qualityRate = framesPerSecond;
  if (m_runtime)
    m_runtime->updatePixelError();
  return TRUE;
}

SbBool TeEngine::setQualityRange(double finest, double coarsest) {
  const TeStatus ok = m_settings.quality.setRange(finest, coarsest);
  if (!ok)
    return fail({"TeEngine: " + ok.error().message});
  if (m_runtime)
    m_runtime->updatePixelError();
  return TRUE;
}

SbBool TeEngine::setUnitBudget(int units) {
  if (!checkSetting(units >= 0, "a budget of " + std::to_string(units) + " units is below 0"))
    return FALSE;
  m_settings.unitBudget = units;
  return TRUE;
}

SbBool TeEngine::setWorkers(int workers) {
  if (!checkEarly("the number of workers") ||
      !checkSetting(workers >= 0 && workers <= kMaxWorkers,
                    std::to_string(workers) + " workers are not 0 to " + std::to_string(kMaxWorkers)))
    return FALSE;
  m_settings.workers = workers;
  return TRUE;
}

void TeEngine::setColours(const TeSurfaceColours& colours) {
  m_settings.colours = colours;
  if (m_runtime)
    m_runtime->setColours(colours);
}

SbBool TeEngine::initialize() {
  if (m_runtime)
    return fail({"TeEngine: initialize() was called before"});
  std::string missing;
  const auto need = [&missing](bool there, const char* what) {
    if (!there)
      missing += (missing.empty() ? "" : ", ") + std::string(what);
  };
  need(isValid(), "a usable size of patches (the constructor's arguments)");
  need(SoDB::isInitialized(), "SoDB::init()");
  need(bool(m_settings.sceneRoot), "the scene root");
  need(bool(m_settings.sceneCamera), "the scene camera");
  need(m_settings.active != nullptr, "an active object");
  need(!m_settings.hudRoot || m_settings.hudCamera, "the HUD camera");
  need(m_settings.hudRoot || !m_settings.hudCamera, "the HUD root");
  if (!missing.empty())
    return fail({"TeEngine: cannot be initialised without " + missing});
  if (!isBelow(m_settings.sceneRoot.get(), m_settings.sceneCamera.get()))
    return fail({"TeEngine: the scene camera is not below the scene root"});
  if (!updateParams())
    return FALSE;
  auto runtime =
      std::make_unique<TeEngineRuntime>(m_settings, *m_database, m_objects, m_rig, getHud(),
                                        [this](const TePatchKey& key) { return m_patches.count(key) > 0; });
  if (const TeStatus ok = runtime->start(); !ok)
    return fail(ok.error());
  m_runtime = std::move(runtime);
  return TRUE;
}

SbBool TeEngine::timeTick(double dt) {
  if (!m_runtime)
    return fail({"TeEngine: timeTick() needs initialize() first"});
  takeParamsForTick();
  const TeStatus ok = m_runtime->tick(dt);
  return ok ? TRUE : fail(ok.error());
}

void TeEngine::finishJobs() {
  if (m_runtime)
    m_runtime->finishJobs();
}

bool TeEngine::isIdle() const { return !m_runtime || m_runtime->isIdle(); }

bool TeEngine::isMoving() const { return m_runtime && m_runtime->isMoving(); }

bool TeEngine::needsRedraw() const { return m_runtime && m_runtime->needsRedraw(); }

void TeEngine::frameDrawn(double frameSeconds, double drawSeconds, double finishSeconds) {
  if (m_runtime)
    m_runtime->frameDrawn(frameSeconds, drawSeconds, finishSeconds);
}

void TeEngine::postKey(const TeKeyEvent& event) {
  if (m_runtime)
    m_runtime->postKey(event);
}

SbBool TeEngine::addJob(std::unique_ptr<TeJob> job) {
  if (!checkSetting(m_runtime && job, m_runtime ? "no job given" : "addJob() needs initialize() first"))
    return FALSE;
  m_runtime->addJob(std::move(job));
  return TRUE;
}

SbBool TeEngine::setPaused(SbBool paused) {
  if (!m_runtime)
    return FALSE;
  m_runtime->setPaused(paused);
  return TRUE;
}

SbBool TeEngine::isPaused() const { return m_runtime && m_runtime->isPaused(); }

SbBool TeEngine::setWireframe(SbBool wireframe) {
  if (!m_runtime)
    return FALSE;
  m_runtime->setWireframe(wireframe);
  return TRUE;
}

SbBool TeEngine::isWireframe() const { return m_runtime && m_runtime->isWireframe(); }

TeHud& TeEngine::getHud() {
  if (!m_hud)
    m_hud = std::make_unique<TeHud>();
  return *m_hud;
}

const TeStatistics& TeEngine::getStatistics() const {
  static const TeStatistics none;
  return m_runtime ? m_runtime->statistics() : none;
}

std::uint64_t TeEngine::stateHash(bool withTerrain) const {
  std::uint64_t hash = teHashCombine(m_objects.stateHash(), m_rig.stateHash());
  if (withTerrain && m_runtime)
    hash = teHashCombine(hash, m_runtime->terrainHash());
  return hash;
}
