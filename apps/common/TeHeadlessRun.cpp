#include "apps/common/TeHeadlessRun.h"

#include "apps/common/TeHeadlessDrawing.h"
#include "apps/common/TeProgressLine.h"
#include "apps/common/TeScreenshots.h"
#include "apps/common/TeStopwatch.h"
#include "generators/base/TeAllowance.h"
#include "generators/base/TeText.h"

#include <algorithm>

namespace {

/// The frames of a run, all but the final picture.
class Frames {
public:
  Frames(TeEngineSession& session, TeHeadlessDrawing& drawing) : m_session(session), m_drawing(drawing) {}

  TeStatus run() {
    TeProgressLine progress("Running", m_session.common().quiet);
    const int frames = std::max(1, m_session.frames());
    for (int frame = 0; frame < frames && !m_session.ended(); ++frame) {
      if (const TeStatus ok = next(); !ok)
        return ok;
      progress.update(double(frame + 1) / frames);
    }
    return {};
  }

  int count() const { return m_count; }
  int drawn() const { return m_drawn; }
  double meanSeconds() const { return m_drawn > 0 ? m_drawSeconds / m_drawn : 0; }

private:
  TeStatus next() {
    TeEngine& engine = m_session.engine();
    const double passed = m_tick.seconds();
    m_tick = TeStopwatch();
    if (!engine.timeTick(m_session.beforeTick(passed)))
      return TeError{engine.lastError()};
    ++m_count;
    if (const TeStatus ok = m_session.afterTick(); !ok)
      return ok;
    if (engine.needsRedraw() || m_drawn == 0)
      if (const TeStatus ok = draw(); !ok)
        return ok;
    if (m_session.takePictureWanted())
      m_session.savePicture(m_drawing.picture());
    return {};
  }

  TeStatus draw() {
    const double frameSeconds = m_frame.seconds(), before = teThreadCpuSeconds();
    m_frame = TeStopwatch();
    if (const TeStatus ok = m_drawing.draw(); !ok)
      return ok;
    ++m_drawn;
    const double finishSeconds = m_frame.seconds();
    m_drawSeconds += finishSeconds;
    // Frames of a run that repeats have the time that they simulate: what the HUD shows repeats, too.
    const double dt = m_session.common().dt;
    if (dt > 0)
      m_session.engine().frameDrawn(dt, 0);
    else
      m_session.engine().frameDrawn(frameSeconds, teThreadCpuSeconds() - before, finishSeconds);
    m_session.log().drawn(m_session.engine());
    return {};
  }

  TeEngineSession& m_session;
  TeHeadlessDrawing& m_drawing;
  int m_count = 0;
  int m_drawn = 0;
  double m_drawSeconds = 0;
  TeStopwatch m_tick;
  TeStopwatch m_frame; ///< since the last one began to be drawn
};

} // namespace

TeStatus teRunHeadless(TeEngineSession& session, TeReport& report) {
  TeResult<TeHeadlessDrawing> drawing =
      TeHeadlessDrawing::create(session.common(), session.stage().all(), session.stage().background());
  if (!drawing)
    return drawing.error();
  Frames frames(session, *drawing);
  if (const TeStatus ok = frames.run(); !ok)
    return ok;
  session.engine().finishJobs();
  const TeResult<TePicture> picture = drawing->picture();
  if (!picture)
    return picture.error();
  drawing->describe(report);
  report.json()["frames"] = frames.count();
  report.json()["frames_drawn"] = frames.drawn();
  report.addTime("frame_mean", frames.meanSeconds());
  report.json()["state_hash"] = teHexText(session.engine().stateHash(true));
  return teKeepPicture(*picture, session.common(), report);
}
