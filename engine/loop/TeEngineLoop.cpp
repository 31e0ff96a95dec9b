#include "engine/loop/TeEngineLoop.h"

#include "engine/TeEngine.h"

#include <Inventor/nodes/SoEventCallback.h>

#include <algorithm>
#include <utility>

TeEngineLoop::TeEngineLoop(TeEngine& engine, SoSeparator* scene)
    : m_engine(engine), m_scene(scene), m_events(new SoEventCallback) {
  m_events->addEventCallback(
      SoKeyboardEvent::getClassTypeId(),
      [](void* loop, SoEventCallback* node) { static_cast<TeEngineLoop*>(loop)->keyEvent(*node); }, this);
  m_scene->insertChild(m_events.get(), 0);
  const auto tickNow = [](void* loop, SoSensor*) { static_cast<TeEngineLoop*>(loop)->tick(); };
  m_next.setFunction(tickNow);
  m_next.setData(this);
  m_idle.setFunction(tickNow);
  m_idle.setData(this);
  m_alarm.setFunction([](void* loop, SoSensor*) { static_cast<TeEngineLoop*>(loop)->m_next.schedule(); });
  m_alarm.setData(this);
  m_watch.setFunction([](void* loop, SoSensor*) { static_cast<TeEngineLoop*>(loop)->wake(); });
  m_watch.setData(this);
}

TeEngineLoop::~TeEngineLoop() {
  stop();
  if (m_scene->findChild(m_events.get()) >= 0)
    m_scene->removeChild(m_events.get());
}

TeStatus TeEngineLoop::setRate(double ticksPerSecond) {
  if (!(ticksPerSecond >= 1 && ticksPerSecond <= kMaxRate))
    return TeError{"loop: the rate must be 1 to " + std::to_string(int(kMaxRate)) + " ticks a second, not " +
                   std::to_string(ticksPerSecond)};
  m_interval = 1 / ticksPerSecond;
  return {};
}

void TeEngineLoop::start() {
  if (m_state == State::Stopped)
    m_state = State::Sleeping;
  wake();
}

void TeEngineLoop::stop() {
  m_next.unschedule();
  m_alarm.unschedule();
  m_idle.unschedule();
  watch(false);
  m_rested = true;
  m_state = State::Stopped;
}

void TeEngineLoop::wake() {
  if (m_state != State::Sleeping)
    return; // the next tick is on its way and will see to it
  watch(false);
  m_state = State::Moving;
  m_rested = m_frameRested = true;
  m_next.schedule();
}

void TeEngineLoop::frameDrawn(double frameSeconds, double drawSeconds, double finishSeconds) {
  // The time of a rest says nothing about the machine.
  m_engine.frameDrawn(std::exchange(m_frameRested, false) ? m_interval : frameSeconds, drawSeconds,
                      finishSeconds);
  if (!m_engine.isIdle())
    wake();
}

/// Seconds since the tick before. After a rest nothing is known of the time before, but a tick is due.
double TeEngineLoop::elapsed() {
  const SbTime now = SbTime::getTimeOfDay();
  const double passed = m_rested ? m_interval : (now - m_lastTick).getValue();
  m_lastTick = now;
  m_rested = false;
  // The clock may have been set back.
  return std::max(0.0, passed);
}

void TeEngineLoop::tick() {
  const double passed = elapsed();
  m_engine.timeTick(m_beforeTick ? m_beforeTick(passed) : passed);
  ++m_ticks;
  if (m_afterTick)
    m_afterTick();
  if (m_engine.needsRedraw())
    m_scene->touch();
  if (m_state != State::Stopped) // by a call-back
    scheduleNext();
}

void TeEngineLoop::scheduleNext() {
  if (m_engine.isIdle()) {
    m_state = State::Sleeping;
    watch(true);
  } else if (m_engine.isMoving()) {
    m_state = State::Moving;
    m_alarm.setTime(m_lastTick + SbTime(m_interval));
    m_alarm.schedule();
  } else {
    m_state = State::Working;
    m_idle.schedule();
  }
}

void TeEngineLoop::watch(bool watching) {
  if (watching)
    m_watch.attach(m_scene.get());
  else
    m_watch.detach();
}

void TeEngineLoop::keyEvent(SoEventCallback& node) {
  const SoKeyboardEvent* event = static_cast<const SoKeyboardEvent*>(node.getEvent());
  TeKeyEvent key;
  key.key = event->getKey();
  key.down = event->getState() == SoButtonEvent::DOWN;
  key.shift = event->wasShiftDown();
  key.control = event->wasCtrlDown();
  key.alt = event->wasAltDown();
  post(key);
  node.setHandled();
}

void TeEngineLoop::post(const TeKeyEvent& key) {
  const auto held = std::find_if(m_held.begin(), m_held.end(),
                                 [&](const TeKeyEvent& other) { return other.key == key.key; });
  if (key.down == (held != m_held.end()))
    return; // a repetition, or the end of a key that went down elsewhere
  if (key.down)
    m_held.push_back(key);
  else
    m_held.erase(held);
  if (m_filter && !m_filter(key))
    return;
  m_engine.postKey(key);
  wake();
}

void TeEngineLoop::releaseKeys() {
  while (!m_held.empty()) {
    TeKeyEvent key = m_held.back();
    key.down = false;
    post(key);
  }
}
