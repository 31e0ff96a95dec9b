#pragma once

#include "apps/common/TeEngineApp.h"
#include "apps/common/TeEngineLog.h"
#include "apps/common/TeEngineStage.h"
#include "engine/input/TeRecorder.h"
#include "engine/input/TeReplay.h"
#include "nodes/TePicture.h"

#include <optional>

/// One run of an application: the stage with the application's objects, the keys that come and are recorded
/// or replayed, and what is to be told in the end. Whoever draws it asks beforeTick() and afterTick().
class TeEngineSession {
public:
  TeEngineSession(const std::string& application, const TeEngineOptions& options,
                  const TeCommonOptions& common, TeEngineApp& app);

  /// Makes the world, the objects, the first patch. Error: bad options or input.
  TeStatus prepare();
  /// Begins the recording. Error: it cannot be written.
  TeStatus startRecording();

  TeEngineStage& stage() { return *m_stage; }
  TeEngine& engine() { return m_stage->engine(); }
  const TeCommonOptions& common() const { return m_common; }
  const TeEngineOptions& options() const { return m_options; }
  TeEngineLog& log() { return *m_log; }
  bool replays() const { return m_replay.has_value(); }
  /// Frames of a recording that is replayed, or those asked for; 0 = no end.
  int frames() const;

  /// Seconds to simulate where so many have passed. Sends a replay's keys.
  double beforeTick(double passed);
  /// Records the tick, or compares it with the recording. Error: it differs.
  TeStatus afterTick();
  /// A key from the user on its way to the engine.
  void heard(const TeKeyEvent& key) { m_keys.push_back(key); }
  /// Esc, or the end of a replay.
  bool ended() const { return m_ended; }
  /// True once after F12.
  bool takePictureWanted();
  /// Writes the next free picture of the user's folder, and says so.
  void savePicture(const TeResult<TePicture>& picture);

  /// Ends the recording. Error: it cannot be written.
  TeStatus finish();
  /// One line about what was done.
  std::string summary() const;
  void describe(nlohmann::ordered_json& report) const;

private:
  TeRecorder::Settings settings() const;
  bool handleKey(const TeKeyEvent& key);

  std::string m_application;
  const TeEngineOptions& m_options;
  const TeCommonOptions& m_common;
  TeEngineApp& m_app;
  std::unique_ptr<TeEngineStage> m_stage;
  std::unique_ptr<TeEngineLog> m_log;
  std::unique_ptr<TeRecorder> m_recorder;
  std::optional<TeReplay> m_replay;
  std::size_t m_frame = 0;
  double m_dt = 0;
  std::vector<TeKeyEvent> m_keys; ///< of the coming tick
  bool m_ended = false;
  bool m_pictureWanted = false;
};
