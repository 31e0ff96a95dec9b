#pragma once

#include "engine/input/TeKeyEvent.h"
#include "generators/base/TeResult.h"
#include "nodes/TeNodePtr.h"

#include <Inventor/SbTime.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/sensors/SoAlarmSensor.h>
#include <Inventor/sensors/SoIdleSensor.h>
#include <Inventor/sensors/SoNodeSensor.h>
#include <Inventor/sensors/SoOneShotSensor.h>

#include <cstdint>
#include <functional>
#include <vector>

class SoEventCallback;
class TeEngine;

/// Runs an engine's ticks from Coin's sensors, in any window toolkit that serves them.
///
/// While something moves, ticks follow each other at the wanted rate, timed by an alarm sensor. While only
/// jobs are left, they run whenever the program is idle (SoIdleSensor). Once the engine is idle there is no
/// sensor, no tick and no redraw, until a key comes, the scene is changed by somebody, or wake() is called.
/// Keys reach the engine through an event node at the scene's beginning.
/// Redraws follow from changes of the scene, as always in Inventor.
/// For the thread that makes all Coin calls.
class TeEngineLoop {
public:
  static constexpr double kDefaultRate = 60; ///< ticks a second
  static constexpr double kMaxRate = 1000;

  enum class State {
    Stopped,
    Moving,   ///< ticks at the wanted rate
    Working,  ///< ticks as long as there are jobs
    Sleeping, ///< nothing to do
  };

  /// The scene is the root that was given to the engine; both outlive the loop.
  TeEngineLoop(TeEngine& engine, SoSeparator* scene);
  ~TeEngineLoop();
  TeEngineLoop(const TeEngineLoop&) = delete;
  TeEngineLoop& operator=(const TeEngineLoop&) = delete;

  /// The most ticks a second while something moves. Error: not within 1 .. kMaxRate.
  TeStatus setRate(double ticksPerSecond);
  /// Called before every tick with the seconds that have passed; what it returns is simulated. By default
  /// just that.
  void setBeforeTick(std::function<double(double passed)> callback) { m_beforeTick = std::move(callback); }
  void setAfterTick(std::function<void()> callback) { m_afterTick = std::move(callback); }
  /// Asked about every key before the engine gets it; false: it does not get it.
  void setKeyFilter(std::function<bool(const TeKeyEvent& key)> filter) { m_filter = std::move(filter); }

  /// After TeEngine::initialize().
  void start();
  void stop();
  State state() const { return m_state; }
  /// Something that the loop cannot see has changed, such as an object's velocity.
  void wake();
  /// A frame was drawn; passed on to the engine, which may have more to do for it.
  void frameDrawn(double frameSeconds, double drawSeconds, double finishSeconds = 0);
  /// Lets go of all held keys, as when the window loses them.
  void releaseKeys();

  std::int64_t ticks() const { return m_ticks; }

private:
  void tick();
  void scheduleNext();
  double elapsed();
  void watch(bool watching);
  void keyEvent(SoEventCallback& node);
  void post(const TeKeyEvent& key);

  TeEngine& m_engine;
  TeNodePtr<SoSeparator> m_scene;
  TeNodePtr<SoEventCallback> m_events;
  SoOneShotSensor m_next;
  SoAlarmSensor m_alarm;
  SoIdleSensor m_idle;
  SoNodeSensor m_watch; ///< attached only while sleeping
  State m_state = State::Stopped;
  double m_interval = 1 / kDefaultRate;
  bool m_frameRested = true; ///< there was a rest since the last frame
  SbTime m_lastTick;
  bool m_rested = true; ///< no tick before this one that time could be measured from
  std::function<double(double)> m_beforeTick;
  std::function<void()> m_afterTick;
  std::function<bool(const TeKeyEvent&)> m_filter;
  std::vector<TeKeyEvent> m_held; ///< keys that are down
  std::int64_t m_ticks = 0;
};
