#include "apps/terrane-view/TeViewHeadless.h"

#include "apps/common/TeProgressLine.h"
#include "nodes/TeSceneRenderer.h"

#include <algorithm>
#include <chrono>

namespace {

constexpr int kSamplesPerPixel = 4; ///< of the final picture
constexpr int kMostWaiting = 2000;  ///< frames until all uploads must be done

double wallSeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

using Renderer = std::unique_ptr<TeSceneRenderer>;

TeResult<Renderer> rendererOf(TeContext& context, TeViewStage& stage, int samples) {
  TeResult<Renderer> renderer = TeSceneRenderer::create(context, context.width(), context.height(), samples);
  if (renderer) {
    (*renderer)->setFitClipPlanes(false);
    (*renderer)->setBackground(stage.background());
  }
  return renderer;
}

TeStatus drawFrames(TeViewSession& session, TeContext& context) {
  const TeResult<Renderer> renderer = rendererOf(context, session.stage(), 1);
  if (!renderer)
    return renderer.error();
  const int frames = std::max(1, session.common().frames);
  const double dt = session.common().dt;
  TeProgressLine progress("Flying", session.common().quiet);
  double last = wallSeconds();
  for (int frame = 0; frame < frames; ++frame) {
    const double now = wallSeconds();
    session.advance(dt > 0 ? dt : now - last);
    last = now;
    const double begin = wallSeconds();
    if (const TeStatus ok = (*renderer)->draw(&session.stage().all()); !ok)
      return ok;
    const double seconds = wallSeconds() - begin;
    session.drawn(seconds, seconds);
    progress.update(double(frame + 1) / frames);
  }
  for (int frame = 0; frame < kMostWaiting && session.nodes().areLoading(); ++frame)
    if (const TeStatus ok = (*renderer)->draw(&session.stage().all()); !ok)
      return ok;
  return {};
}

TeResult<TePicture> finalPicture(TeViewSession& session, TeContext& context) {
  const TeResult<Renderer> fine = rendererOf(context, session.stage(), kSamplesPerPixel);
  if (!fine)
    return fine.error();
  session.advance(0); // so that the text tells of the last frame
  return (*fine)->render(&session.stage().all());
}

} // namespace

TeStatus teViewHeadless(TeViewSession& session, TeReport& report) {
  const TeCommonOptions& common = session.common();
  const TeResult<TeContextKind> kind = teContextKind(common.context);
  if (!kind)
    return kind.error();
  const auto context = TeContext::create(*kind, common.width, common.height);
  if (!context)
    return context.error();
  if (const TeStatus ok = drawFrames(session, **context); !ok)
    return ok;
  const TeResult<TePicture> picture = finalPicture(session, **context);
  if (!picture)
    return picture.error();
  auto& json = report.json();
  json["context"] = common.context;
  json["renderer"] = (*context)->renderer();
  json["frames"] = session.log().frames();
  report.addTime("frame_mean", session.log().meanSeconds());
  report.addTime("frame_longest", session.log().longestSeconds());
  report.addPicture(*picture);
  return common.offscreen.empty() ? TeStatus() : picture->writePng(common.offscreen);
}
