#include "apps/terrane-view/TeViewHeadless.h"

#include "apps/common/TeHeadlessDrawing.h"
#include "apps/common/TeProgressLine.h"
#include "apps/common/TeScreenshots.h"
#include "apps/common/TeStopwatch.h"

#include <algorithm>

namespace {

constexpr int kMostWaiting = 2000; ///< frames until all uploads must be done

TeStatus drawFrames(TeViewSession& session, TeHeadlessDrawing& drawing) {
  const int frames = std::max(1, session.common().frames);
  const double dt = session.common().dt;
  TeProgressLine progress("Flying", session.common().quiet);
  TeStopwatch tick;
  for (int frame = 0; frame < frames; ++frame) {
    const double passed = tick.seconds();
    tick = TeStopwatch();
    session.advance(dt > 0 ? dt : passed);
    const TeStopwatch time;
    if (const TeStatus ok = drawing.draw(); !ok)
      return ok;
    const double seconds = time.seconds();
    session.drawn(seconds, seconds);
    progress.update(double(frame + 1) / frames);
  }
  for (int frame = 0; frame < kMostWaiting && session.nodes().areLoading(); ++frame)
    if (const TeStatus ok = drawing.draw(); !ok)
      return ok;
  return {};
}

} // namespace

TeStatus teViewHeadless(TeViewSession& session, TeReport& report) {
  TeResult<TeHeadlessDrawing> drawing =
      TeHeadlessDrawing::create(session.common(), session.stage().all(), session.stage().background());
  if (!drawing)
    return drawing.error();
  if (const TeStatus ok = drawFrames(session, *drawing); !ok)
    return ok;
  session.advance(0); // so that the text tells of the last frame
  const TeResult<TePicture> picture = drawing->picture();
  if (!picture)
    return picture.error();
  drawing->describe(report);
  report.json()["frames"] = session.log().frames();
  report.addTime("frame_mean", session.log().meanSeconds());
  report.addTime("frame_longest", session.log().longestSeconds());
  return teKeepPicture(*picture, session.common(), report);
}
