#include "apps/common/TeWindowRun.h"

#include "apps/common/TeScreenshots.h"
#include "engine/loop/TeEngineLoop.h"
#include "generators/base/TeText.h"

#include <Inventor/SoDB.h>

#include <algorithm>

namespace {

/// Joins a session, a loop and a window.
class Client : public TeWindowClient {
public:
  explicit Client(TeEngineSession& session)
      : m_session(session), m_loop(session.engine(), &session.stage().scene()) {
    m_loop.setBeforeTick([this](double passed) { return m_session.beforeTick(passed); });
    m_loop.setAfterTick([this] { ticked(); });
    m_loop.setKeyFilter([this](const TeKeyEvent& key) { return heard(key); });
  }

  TeStatus setRate(double framesPerSecond) {
    return framesPerSecond > 0 ? m_loop.setRate(framesPerSecond) : TeStatus();
  }
  const TeStatus& status() const { return m_status; }

  void opened(TeWindow& window) override {
    m_window = &window;
    m_loop.start();
  }
  void resized(int width, int height) override { m_session.stage().setSize(width, height); }
  void drawn(double frameSeconds, double drawSeconds, double finishSeconds) override {
    m_loop.frameDrawn(frameSeconds, drawSeconds, finishSeconds);
    m_session.log().drawn(m_session.engine());
  }
  void keysLost() override { m_loop.releaseKeys(); }

private:
  /// A replay has its own keys; only Esc counts.
  bool heard(const TeKeyEvent& key) {
    if (m_session.replays()) {
      if (key.key == SoKeyboardEvent::ESCAPE)
        end();
      return false;
    }
    m_session.heard(key);
    return true;
  }

  void ticked() {
    m_status = m_session.afterTick();
    if (m_session.takePictureWanted())
      m_window->capture([this](const TeResult<TePicture>& picture) { m_session.savePicture(picture); });
    if (!m_status || m_session.ended())
      end();
  }

  void end() {
    m_loop.stop();
    m_window->close();
  }

  TeEngineSession& m_session;
  TeEngineLoop m_loop;
  TeWindow* m_window = nullptr;
  TeStatus m_status;
};

} // namespace

TeResult<TeViewerSession> teShowInWindow(SoNode& scene, const std::string& title, const SbColor& background,
                                         const TeCommonOptions& common, TeWindowClient& client,
                                         TeReport& report) {
  TeViewerOptions viewer;
  viewer.title = title;
  viewer.width = common.width;
  viewer.height = common.height;
  viewer.background = background;
  viewer.frames = common.offscreen.empty() ? common.frames : std::max(1, common.frames);
  SoDB::setRealTimeInterval(SbTime::zero()); // a timer of Coin's, which nothing here needs
  TeResult<TeViewerSession> shown = teRunWindow(&scene, viewer, client);
  if (shown) {
    report.json()["context"] = common.context;
    report.json()["renderer"] = shown->renderer;
  }
  return shown;
}

TeStatus teRunInWindow(TeEngineSession& session, const std::string& title, TeReport& report) {
  Client client(session);
  if (const TeStatus ok = client.setRate(session.options().fps); !ok)
    return ok;
  const TeResult<TeViewerSession> shown = teShowInWindow(
      session.stage().all(), title, session.stage().background(), session.common(), client, report);
  if (!shown)
    return shown.error();
  if (!client.status())
    return client.status();
  report.json()["frames"] = session.engine().getStatistics().redraws;
  report.addTime("frame_mean", shown->meanSeconds);
  report.addTime("frame_longest", shown->longestSeconds);
  report.json()["state_hash"] = teHexText(session.engine().stateHash());
  return teKeepPicture(shown->picture, session.common(), report);
}
