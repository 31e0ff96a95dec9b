#include "apps/common/TeEngineSession.h"

#include "apps/common/TeScreenshots.h"
#include "generators/base/TeText.h"

std::optional<double> teGroundAt(TeEngine& engine, glm::dvec2 point) {
  TePatch* patch = engine.getPatch(SbVec2d(point.x, point.y));
  if (!patch || !patch->prepareBuildMaps() || !patch->buildHMapFromBuildMaps())
    return {};
  return engine.getDatabase()->heightAt(point);
}

TeEngineSession::TeEngineSession(const std::string& application, const TeEngineOptions& options,
                                 const TeCommonOptions& common, TeEngineApp& app)
    : m_application(application), m_options(options), m_common(common), m_app(app) {}

TeStatus TeEngineSession::prepare() {
  TeResult<std::unique_ptr<TeEngineStage>> stage = TeEngineStage::create(m_options, m_common);
  if (!stage)
    return stage.error();
  m_stage = std::move(*stage);
  m_log = std::make_unique<TeEngineLog>(m_stage->patchSide());
  if (const TeStatus ok = m_app.setUp(engine(), m_stage->scene(), m_stage->start()); !ok)
    return ok;
  if (!m_options.replay.empty()) {
    TeResult<TeReplay> replay = TeReplay::read(m_options.replay, settings());
    if (!replay)
      return replay.error();
    m_replay = std::move(*replay);
  }
  engine().setKeyCallback([this](const TeKeyEvent& key) { return handleKey(key); });
  return engine().initialize() ? TeStatus() : TeError{engine().lastError()};
}

TeStatus TeEngineSession::startRecording() {
  if (m_options.record.empty())
    return {};
  TeResult<std::unique_ptr<TeRecorder>> recorder = TeRecorder::create(m_options.record, settings());
  if (!recorder)
    return recorder.error();
  m_recorder = std::move(*recorder);
  return {};
}

/// All that decides where objects and camera are, and what is seen. Workers and budgets do not.
TeRecorder::Settings TeEngineSession::settings() const {
  const TeTerrainOptions& terrain = m_options.terrain;
  TeRecorder::Settings settings;
  settings["application"] = m_application;
  settings["seed"] = std::to_string(m_common.seed);
  settings["dt"] = teNumberText(m_common.dt);
  settings["terrain"] = m_stage->terrain();
  settings["samples"] = std::to_string(terrain.samples);
  settings["spacing"] = teNumberText(terrain.spacing);
  settings["blend"] = terrain.blending == TeBlendProfile::Smooth ? "smooth" : "linear";
  settings["elevation"] = terrain.reading.verticalUnit + " " + teNumberText(terrain.reading.posts) + " " +
                          terrain.outside + (terrain.reading.fillVoids ? " filled" : "") +
                          (terrain.native ? " native" : "");
  settings["center"] = teNumberText(m_options.center.x) + "," + teNumberText(m_options.center.y);
  settings["radius"] = std::to_string(m_options.radius);
  settings["view"] = m_options.thirdPerson ? "third" : "first";
  for (const auto& [name, value] : m_app.settings())
    settings[name] = value;
  return settings;
}

int TeEngineSession::frames() const {
  if (!m_replay)
    return m_common.frames;
  const int recorded = int(m_replay->frames().size());
  return m_common.frames > 0 ? std::min(m_common.frames, recorded) : recorded;
}

double TeEngineSession::beforeTick(double passed) {
  m_dt = m_common.dt > 0 ? m_common.dt : passed;
  if (m_replay && m_frame < m_replay->frames().size()) {
    const TeRecordedFrame& frame = m_replay->frames()[m_frame];
    m_dt = frame.dt;
    for (const TeKeyEvent& key : frame.keys)
      engine().postKey(key);
  }
  if (!engine().isPaused())
    m_app.beforeTick(m_dt);
  return m_dt;
}

TeStatus TeEngineSession::afterTick() {
  m_app.afterTick();
  m_log->ticked(engine(), m_dt);
  if (m_recorder) {
    TeRecordedFrame frame{m_dt, std::move(m_keys), {}};
    if (m_common.dt > 0)
      frame.stateHash = engine().stateHash();
    m_recorder->add(frame);
  }
  m_keys.clear();
  if (m_replay) {
    if (const TeStatus ok = m_replay->compare(m_frame, engine().stateHash()); !ok)
      return ok;
    m_ended = m_ended || int(m_frame) + 1 == frames();
  }
  ++m_frame;
  return {};
}

bool TeEngineSession::handleKey(const TeKeyEvent& key) {
  if (key.down && key.key == SoKeyboardEvent::ESCAPE) {
    m_ended = true;
    return true;
  }
  if (key.down && (key.key == SoKeyboardEvent::F12 || key.key == SoKeyboardEvent::G)) {
    m_pictureWanted = true;
    return true;
  }
  return m_app.handleKey(key);
}

bool TeEngineSession::takePictureWanted() { return std::exchange(m_pictureWanted, false); }

void TeEngineSession::savePicture(const TeResult<TePicture>& picture) {
  teSaveScreenshot(picture, m_options.screenshots, m_application);
}

TeStatus TeEngineSession::finish() { return m_recorder ? m_recorder->finish() : TeStatus(); }

std::string TeEngineSession::summary() const {
  const TeStatistics& statistics = m_stage->engine().getStatistics();
  return teFormat("%lld ticks, the worst %.1f ms of %.1f; %lld patches made, %lld drawn",
                  static_cast<long long>(statistics.ticks), 1000 * statistics.worstTickSeconds,
                  1000 * statistics.budgetSeconds, static_cast<long long>(statistics.patches.made),
                  static_cast<long long>(statistics.patches.drawn));
}

void TeEngineSession::describe(nlohmann::ordered_json& report) const {
  report["seed"] = m_common.seed;
  report["generator"] = m_stage->terrain();
  report["radius"] = m_options.radius;
  report["workers"] = m_options.workers;
  report["units"] = m_options.unitBudget(m_common);
  m_log->describe(m_stage->engine(), report);
  m_app.describe(report);
}
