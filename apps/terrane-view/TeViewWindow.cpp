#include "apps/terrane-view/TeViewWindow.h"

#include "apps/common/TeScreenshots.h"
#include "apps/common/TeWindowRun.h"

#include <Inventor/events/SoLocation2Event.h>
#include <Inventor/events/SoMouseButtonEvent.h>
#include <Inventor/nodes/SoEventCallback.h>
#include <Inventor/sensors/SoAlarmSensor.h>

#include <algorithm>
#include <optional>

namespace {

constexpr double kInterval = 1.0 / 60;     ///< seconds between ticks while something moves
constexpr double kLongestTick = 0.25;      ///< seconds; what a rest was longer is not flown
constexpr double kRadiansPerPixel = 0.004; ///< of a drag
constexpr double kWheelStep = 1.3;         ///< factor on the speed

/// Joins a session and a window. While something moves or uploads wait, ticks follow each other; else there
/// is no timer.
class Client : public TeWindowClient {
public:
  explicit Client(TeViewSession& session) : m_session(session), m_events(new SoEventCallback) {
    listen<SoKeyboardEvent>([](void* self, SoEventCallback* node) {
      static_cast<Client*>(self)->key(static_cast<const SoKeyboardEvent&>(*node->getEvent()));
    });
    listen<SoMouseButtonEvent>([](void* self, SoEventCallback* node) {
      static_cast<Client*>(self)->button(static_cast<const SoMouseButtonEvent&>(*node->getEvent()));
    });
    listen<SoLocation2Event>([](void* self, SoEventCallback* node) {
      static_cast<Client*>(self)->moved(node->getEvent()->getPosition());
    });
    m_session.stage().all().insertChild(m_events.get(), 0);
    m_alarm.setFunction([](void* self, SoSensor*) { static_cast<Client*>(self)->tick(); });
    m_alarm.setData(this);
  }
  ~Client() override {
    m_alarm.unschedule();
    m_session.stage().all().removeChild(m_events.get());
  }

  void opened(TeWindow& window) override {
    m_window = &window;
    wake();
  }
  void resized(int width, int height) override {
    m_session.stage().setSize(width, height);
    wake();
  }
  void drawn(double frameSeconds, double drawSeconds, double finishSeconds) override {
    // The time of a rest says nothing about drawing.
    m_session.drawn(m_rested ? drawSeconds : frameSeconds, finishSeconds);
    if (m_session.nodes().areLoading())
      wake(); // for the text's sake; the nodes themselves ask for frames
    m_rested = !m_alarm.isScheduled();
  }
  void keysLost() override {
    m_session.flight().releaseKeys();
    m_drag.reset();
  }

private:
  template <class Event> void listen(SoEventCallbackCB* heard) {
    m_events->addEventCallback(Event::getClassTypeId(), heard, this);
  }

  void key(const SoKeyboardEvent& event) {
    m_session.heard(TeKeyEvent::of(event));
    m_events->setHandled();
    if (m_session.ended())
      return m_window->close();
    if (m_session.takePictureWanted())
      m_window->capture([this](const TeResult<TePicture>& picture) { m_session.savePicture(picture); });
    wake();
  }

  void button(const SoMouseButtonEvent& event) {
    TeFlyCamera* camera = m_session.flight().camera();
    const bool down = event.getState() == SoButtonEvent::DOWN;
    if (event.getButton() == SoMouseButtonEvent::BUTTON1)
      m_drag = down ? std::optional<SbVec2s>(event.getPosition()) : std::nullopt;
    else if (camera && down && event.getButton() == SoMouseButtonEvent::BUTTON4)
      camera->makeFaster(kWheelStep);
    else if (camera && down && event.getButton() == SoMouseButtonEvent::BUTTON5)
      camera->makeFaster(1 / kWheelStep);
  }

  void moved(const SbVec2s& place) {
    TeFlyCamera* camera = m_session.flight().camera();
    if (!m_drag || !camera)
      return;
    camera->turn(kRadiansPerPixel * (place[0] - (*m_drag)[0]), -kRadiansPerPixel * (place[1] - (*m_drag)[1]));
    m_drag = place;
    wake();
  }

  void wake() {
    if (!m_alarm.isScheduled())
      schedule();
  }
  void schedule() {
    m_alarm.setTimeFromNow(SbTime(kInterval));
    m_alarm.schedule();
  }

  void tick() {
    const SbTime now = SbTime::getTimeOfDay();
    const double passed = (now - m_last).getValue();
    m_last = now;
    const double dt = m_session.common().dt;
    // After a rest nothing is known of the time before.
    m_session.advance(dt > 0 ? dt : passed >= 0 && passed <= kLongestTick ? passed : kInterval);
    if (m_session.moving())
      m_session.stage().scene().touch();
    if (m_session.moving())
      schedule();
  }

  TeViewSession& m_session;
  TeNodePtr<SoEventCallback> m_events;
  SoAlarmSensor m_alarm;
  SbTime m_last = SbTime::zero();
  bool m_rested = true; ///< nothing was to be done since the last frame
  TeWindow* m_window = nullptr;
  std::optional<SbVec2s> m_drag; ///< where the mouse was, while its button is down
};

} // namespace

TeStatus teViewWindow(TeViewSession& session, TeReport& report) {
  Client client(session);
  const TeResult<TeViewerSession> shown = teShowInWindow(
      session.stage().all(), "terrane-view", session.stage().background(), session.common(), client, report);
  if (!shown)
    return shown.error();
  report.json()["frames"] = shown->frames;
  report.addTime("frame_mean", shown->meanSeconds);
  report.addTime("frame_longest", shown->longestSeconds);
  return teKeepPicture(shown->picture, session.common(), report);
}
