#include "engine/TeEngineRuntime.h"

#include "engine/hud/TeHudHelp.h"
#include "engine/hud/TeHudLines.h"
#include "generators/base/TeLog.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

/// Numbers that change every frame cannot be read.
constexpr double kHudSeconds = 0.1;
/// Part of a tick's allowance that may go into buffers for the next anchor.
constexpr double kAnchorShare = 0.25;
/// Part of the longest time lately that is left after a tick.
constexpr double kForget = 0.95;
/// No unit is to take longer, at 65 samples.
constexpr double kLongestUnit = 0.00025;
/// A frame that takes longer by this factor than it is to take did not just wait for the display.
constexpr double kLate = 1.1;
constexpr std::size_t kAnchorBytes = 1 << 18; ///< where work is counted in units

void keepLargest(TeStatistics::Memory& peak, const TeStatistics::Memory& now) {
  peak.maps = std::max(peak.maps, now.maps);
  peak.heights = std::max(peak.heights, now.heights);
  peak.meshes = std::max(peak.meshes, now.meshes);
  peak.buffers = std::max(peak.buffers, now.buffers);
  peak.records = std::max(peak.records, now.records);
}

/// Calls a copy, so that a call-back may replace itself.
template <class Function, class... Arguments> void call(const Function& function, Arguments&&... arguments) {
  if (const Function called = function)
    called(std::forward<Arguments>(arguments)...);
}

/// Rock and snow lines that suit a world, judged by the source maps of one of its patches.
TeSurfaceColours coloursOf(const TePatchData& patch) {
  double mean = 0;
  float highest = patch.maximum();
  int maps = 0;
  for (const TeSourceMapPtr& map : patch.maps())
    if (map) {
      const TeMapStatistics statistics = map->heights.statistics();
      mean += statistics.mean;
      highest = std::max(highest, statistics.maximum);
      ++maps;
    }
  return TeSurfaceColours::forHeights(maps > 0 ? float(mean / maps) : patch.minimum(), highest);
}

} // namespace

TeEngineRuntime::TeEngineRuntime(TeEngineSettings& settings, TePatchDatabase& database, TeObjects& objects,
                                 TeCameraRig& rig, TeHud& hud, TeTerrain::Held held)
    : m_settings(settings), m_database(database), m_objects(objects), m_rig(rig), m_hud(hud),
      m_maps(database), m_scene(database.lattice(), settings.active->position()),
      m_terrain(database, m_scene, m_queue, m_maps, std::move(held)) {
  m_terrain.setRadius(settings.radius);
}

TeEngineRuntime::~TeEngineRuntime() {
  m_settings.sceneRoot->removeChild(m_scene.root());
  m_settings.sceneRoot->removeChild(m_objectScene.root());
}

TeStatus TeEngineRuntime::start() {
  if (const TeStatus ok = m_maps.setWorkers(m_settings.workers); !ok)
    return ok;
  const glm::dvec3& position = m_settings.active->position();
  const TeResult<TePatchKey> key = tePatchAt(m_database.lattice(), {position.x, position.y});
  if (!key)
    return key.error();
  // The colours come from the heights, and the patch's own pieces have to have them, too.
  const TeResult<TePatchData*> ground = m_database.build(*key);
  if (!ground)
    return ground.error();
  m_terrain.setColours(m_settings.colours ? *m_settings.colours : coloursOf(**ground));
  updatePixelError();
  if (const TeStatus ok = m_terrain.build(*key); !ok)
    return ok;
  m_settings.sceneRoot->addChild(m_scene.root());
  m_settings.sceneRoot->addChild(m_objectScene.root());
  if (m_settings.hudRoot)
    if (const TeStatus ok = m_hud.attach(m_settings.hudRoot.get(), m_settings.hudCamera.get()); !ok)
      return ok;
  for (const auto& object : m_objects.all())
    addObject(*object);
  m_terrain.buildGround();
  m_statistics.budgetSeconds = m_settings.budget.budget();
  followObject(0);
  m_scene.jump(m_rig.eye());
  m_objectScene.placeAll(m_scene.origin());
  updateCamera();
  updateStatistics();
  updateHud();
  return {};
}

void TeEngineRuntime::setRadius(int radius) { m_terrain.setRadius(radius); }

void TeEngineRuntime::updatePixelError() {
  const TeQuality& quality = m_settings.quality;
  const double pixels = quality.governs() ? quality.pixelError() : m_settings.pixelError;
  m_changed = m_changed || pixels != m_statistics.pixelError;
  m_scene.drawing()->setPixelError(pixels);
  m_statistics.pixelError = pixels;
  m_statistics.frameGoalSeconds = quality.governs() ? 1 / m_settings.qualityRate : 0;
}

void TeEngineRuntime::setWireframe(bool wireframe) {
  m_wireframe = wireframe;
  m_scene.setWireframe(wireframe);
  m_changed = true;
}

void TeEngineRuntime::addObject(TeObject& object) {
  m_objectScene.add(object, m_scene.origin());
  m_terrain.place(object, &object == m_settings.active);
  m_changed = true;
}

void TeEngineRuntime::removeObject(const TeObject& object) {
  m_objectScene.remove(object);
  m_terrain.forget(object);
  m_changed = true;
}

TeStatus TeEngineRuntime::tick(double dt) {
  if (!(dt >= 0) || std::isinf(dt))
    return TeError{"time of a tick: " + std::to_string(dt) + " s is not a number of at least 0"};
  if (m_ticking)
    return TeError{"a tick within a tick: timeTick() was called by a call-back that is part of one"};
  m_ticking = true;
  closeTick();
  const bool wasIdle = isIdle();
  m_errorChanged = false;
  const double begin = teThreadCpuSeconds();
  handleKeys();
  simulate(m_paused ? 0 : dt);
  m_statistics.budgetSeconds = m_settings.budget.budget();
  TeAllowance slice = allowance();
  followObject(dt);
  work(slice);
  countSlice(slice);
  const double worked = teThreadCpuSeconds();
  updateCamera();
  updateStatistics();
  countFrame();
  m_hudIsOld = m_hudIsOld || (!wasIdle && isIdle()); // no later tick may show the state of rest
  updateHud();
  ++m_statistics.ticks;
  const double end = teThreadCpuSeconds();
  m_statistics.tickSeconds = end - begin;
  // What comes after the slice has to fit into the budget, too.
  m_after = std::max(end - worked, kForget * m_after);
  m_tickOpen = true;
  m_ticking = false;
  callBack();
  return {};
}

void TeEngineRuntime::closeTick() {
  if (!std::exchange(m_tickOpen, false))
    return;
  const TeMeshDrawing::Frame& frame = m_scene.drawing()->frame();
  m_statistics.drawing = {
      frame.meshesDrawn,   frame.meshesCulled,          frame.triangles, frame.uploads, frame.bytesUploaded,
      frame.uploadSeconds, m_statistics.drawing.seconds};
  m_statistics.errorBoundPixels = frame.errorBound;
  m_statistics.tickSeconds += frame.uploadSeconds;
  m_statistics.worstTickSeconds = std::max(m_statistics.worstTickSeconds, m_statistics.tickSeconds);
  if (m_statistics.tickSeconds > m_statistics.budgetSeconds)
    ++m_statistics.ticksOverBudget;
  m_settings.budget.tickDone(m_statistics.tickSeconds, m_longestUnit);
}

void TeEngineRuntime::frameDrawn(double frameSeconds, double drawSeconds, double finishSeconds) {
  closeTick();
  m_changed = false;
  ++m_statistics.redraws;
  m_statistics.frameSeconds = frameSeconds;
  m_settings.budget.frameDrawn(frameSeconds, drawSeconds);
  if (m_settings.quality.governs())
    steerQuality(frameSeconds, drawSeconds, finishSeconds);
}

/// By what drawing takes, without making terrain and its uploads: what these may take depends on drawing, so
/// the error must not depend on them.
void TeEngineRuntime::steerQuality(double frameSeconds, double drawSeconds, double finishSeconds) {
  double seconds = drawSeconds;
  if (finishSeconds > 0)
    seconds = finishSeconds;
  else if (frameSeconds > kLate * m_statistics.frameGoalSeconds)
    seconds = std::max(drawSeconds, frameSeconds - m_statistics.tickSeconds);
  seconds = std::max(seconds - m_statistics.drawing.uploadSeconds, 0.0);
  m_statistics.drawing.seconds = seconds;
  m_settings.quality.frameDrawn(seconds);
  m_errorChanged = m_settings.quality.pixelError() != m_statistics.pixelError;
  updatePixelError();
}

void TeEngineRuntime::handleKeys() {
  // A key's handling may post others, for the next tick.
  std::vector<TeKeyEvent> keys;
  keys.swap(m_keys);
  for (const TeKeyEvent& event : keys)
    if (m_pressed.change(event))
      handleKey(event);
}

void TeEngineRuntime::handleKey(const TeKeyEvent& event) {
  m_hudIsOld = true;
  const bool meant = m_settings.active->handleEvent(event);
  // The rig hears of all releases: a key may have gone down for it while another object was active.
  const bool meantForRig = (!meant || !event.down) && m_rig.handleEvent(event);
  if (meant || meantForRig)
    return;
  if (event.down) {
    switch (event.key) {
    case SoKeyboardEvent::F1:
    case SoKeyboardEvent::SLASH:
      m_hud.showHelp(!m_hud.isHelpShown());
      return;
    case SoKeyboardEvent::P:
      m_paused = !m_paused;
      return;
    case SoKeyboardEvent::H:
      m_hud.setVisible(!m_hud.isVisible());
      return;
    case SoKeyboardEvent::W:
    case SoKeyboardEvent::F3:
    case SoKeyboardEvent::X:
      setWireframe(!m_wireframe);
      return;
    default:
      break;
    }
  }
  call(m_settings.key, event);
}

void TeEngineRuntime::simulate(double dt) {
  placeObjects(); // those that a program has moved
  m_inside = true;
  const TeResult<TeObjects::Tick> done = m_objects.update(dt, m_database);
  m_inside = false;
  assert(done); // dt was checked
  m_statistics.simulatedSeconds += done->simulated;
  m_statistics.droppedSeconds += done->dropped;
  m_statistics.objectsHeld += done->held;
  for (const std::string& message : done->errors)
    call(m_settings.error, message);
  for (const TeObject* object : m_objects.touched()) {
    m_terrain.place(*object, object == m_settings.active);
    m_changed = m_objectScene.place(*object, m_scene.origin()) || m_changed;
  }
  if (m_settings.collisions && done->simulated > 0 && !m_objects.touched().empty()) {
    call(m_settings.collisions, done->simulated);
    placeObjects();
  }
}

void TeEngineRuntime::placeObjects() {
  for (const TeObject* object : m_objects.awake()) {
    m_terrain.place(*object, object == m_settings.active);
    m_changed = m_objectScene.place(*object, m_scene.origin()) || m_changed;
  }
}

void TeEngineRuntime::followObject(double dt) {
  const TeObject& object = *m_settings.active;
  m_rig.update(std::min(dt, TeObjects::kLongestTick));
  m_rig.follow(object, m_database);
  const SoPerspectiveCamera& camera = *m_settings.sceneCamera;
  const TeTerrainView view{object.position(), object.velocity(),
                           TeViewFrustum(m_rig.eye(), m_rig.orientation(), camera.heightAngle.getValue(),
                                         camera.aspectRatio.getValue())};
  if (m_terrain.follow(view)) {
    m_wasComplete = false;
    m_statistics.ticksUntilComplete = 0;
    m_scene.jump(m_rig.eye());
    m_objectScene.placeAll(m_scene.origin());
  } else if (m_scene.follow(m_rig.eye(), m_terrain.block().radius)) {
    m_objectScene.placeAll(m_scene.origin());
  }
}

TeAllowance TeEngineRuntime::allowance() const {
  return m_settings.unitBudget > 0
             ? TeAllowance::units(m_settings.unitBudget)
             : TeAllowance::seconds(std::max(m_settings.budget.allowance() - m_after, 0.0));
}

void TeEngineRuntime::countSlice(const TeAllowance& slice) {
  m_longestUnit = slice.longestUnit();
  m_statistics.longestUnitSeconds = std::max(m_statistics.longestUnitSeconds, m_longestUnit);
  if (!slice.countsUnits() && slice.remainingSeconds() < -kLongestUnit)
    ++m_statistics.slicesOverrun;
}

void TeEngineRuntime::work(TeAllowance& allowance) {
  TeMeshDrawing& drawing = *m_scene.drawing();
  const double anchorSeconds = kAnchorShare * m_settings.budget.allowance();
  std::size_t anchorBytes = 0;
  if (drawing.changesAnchor()) {
    anchorBytes =
        m_settings.unitBudget > 0 ? kAnchorBytes : std::size_t(anchorSeconds / drawing.secondsPerByte());
    allowance.charge(anchorSeconds, 0);
  }
  drawing.resetFrame(anchorBytes);
  m_maps.setFixedJoin(m_settings.unitBudget > 0);
  m_maps.beginTick();
  allowance.beginUnit();
  m_inside = true;
  m_terrain.work(allowance);
  m_inside = false;
  m_changed = m_terrain.takeChanged() || drawing.changesAnchor() || m_changed;
}

void TeEngineRuntime::updateCamera() {
  const TeObject& object = *m_settings.active;
  const bool inside = m_rig.person() == TeCameraRig::Person::First;
  m_objectScene.setHidden(inside && !object.drawnInFirstPerson() ? &object : nullptr);
  const double reach = (m_terrain.block().radius + 1) * m_database.lattice().patchSide() * std::sqrt(2.0);
  m_rig.apply(*m_settings.sceneCamera, m_scene.origin(),
              TeClipRange::of(reach, m_rig.heightAboveGround(), inside ? 0 : m_rig.objectDistance()));
  const std::uint64_t hash = m_rig.stateHash();
  m_changed = m_changed || hash != m_viewHash;
  m_viewHash = hash;
}

void TeEngineRuntime::updateStatistics() {
  const TeObject& object = *m_settings.active;
  const std::optional<double> ground = m_database.heightAt({object.position().x, object.position().y});
  m_statistics.heightAboveGround =
      ground ? object.position().z - *ground : std::numeric_limits<double>::quiet_NaN();
  m_terrain.count(m_statistics);
  m_queue.count(m_statistics.jobs);
  m_statistics.jobs.mapsMade = m_maps.mapsMade();
  m_statistics.jobs.mapsShared = m_maps.mapsShared();
  keepLargest(m_statistics.peak, m_statistics.memory);
}

void TeEngineRuntime::countFrame() {
  if (!m_terrain.hasGround(m_settings.active->position()))
    ++m_statistics.framesWithoutGround;
  if (m_statistics.patches.missingInView > 0) {
    ++m_statistics.framesWithMissingInView;
    m_statistics.framesWithMissingLater += m_wasComplete ? 1 : 0;
  }
  m_statistics.ticksUntilComplete += m_wasComplete ? 0 : 1;
  m_wasComplete = m_wasComplete || m_statistics.patches.missing == 0;
}

void TeEngineRuntime::updateHud() {
  if (!m_settings.hudRoot)
    return;
  const double time = m_objects.time();
  if (m_hudIsOld || time >= m_hudTime + kHudSeconds) {
    m_hud.setLines(teHudLines(*m_settings.active, m_statistics));
    if (m_hud.isHelpShown())
      m_hud.setHelp(teHudHelp(*m_settings.active, m_rig, m_hud.programHelp()));
    m_hudTime = time;
    m_hudIsOld = false;
  }
  m_changed = m_changed || m_hud.changes() != m_hudChanges;
  m_hudChanges = m_hud.changes();
}

void TeEngineRuntime::callBack() {
  for (TeTerrain::Event& event : m_terrain.takeEvents())
    m_events.push_back(std::move(event));
  // A call-back may lead to others: those wait for their turn.
  while (!m_events.empty()) {
    const TeTerrain::Event event = std::move(m_events.front());
    m_events.pop_front();
    switch (event.kind) {
    case TeTerrain::Event::Kind::Ready:
      call(m_settings.patchReady, event.key, event.graph.get());
      break;
    case TeTerrain::Event::Kind::Dropped:
      call(m_settings.patchDropped, event.key, event.graph.get());
      break;
    case TeTerrain::Event::Kind::Failed:
      TeLog::error(event.message);
      call(m_settings.error, event.message);
      break;
    }
  }
}

void TeEngineRuntime::finishJobs() {
  if (m_inside)
    return;
  closeTick();
  placeObjects();
  followObject(0);
  do {
    TeAllowance all = TeAllowance::unlimited();
    work(all);
    m_maps.joinAll();
  } while (!m_terrain.complete());
  m_scene.finishAnchor();
  followObject(0); // the camera keeps above ground that was not known before
  updateCamera();
  updateStatistics();
  m_hudIsOld = true;
  updateHud();
  callBack();
}

bool TeEngineRuntime::isMoving() const {
  return (!m_paused && m_objects.anyAwake()) || !m_keys.empty() || m_rig.moving() || m_errorChanged;
}

bool TeEngineRuntime::isIdle() const { return !isMoving() && m_terrain.idle(); }
