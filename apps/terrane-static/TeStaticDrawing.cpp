#include "apps/terrane-static/TeStaticDrawing.h"

#include "apps/common/TeScreenshots.h"
#include "apps/common/TeStopwatch.h"
#include "nodes/TeSceneRenderer.h"
#include "nodes/context/TeViewer.h"

#include <algorithm>

namespace {

constexpr int kSamplesPerPixel = 4;

/// What was drawn, by whom, and how fast.
struct Drawn {
  TePicture picture;
  std::string renderer;
  int frames = 0;
  double meanSeconds = 0;
  double longestSeconds = 0;
};

TeResult<Drawn> drawInWindow(SoNode* scene, const TeCommonOptions& options) {
  TeViewerOptions viewer;
  viewer.width = options.width;
  viewer.height = options.height;
  viewer.frames = options.offscreen.empty() ? options.frames : std::max(1, options.frames);
  TeResult<TeViewerSession> session = teRunViewer(scene, viewer);
  if (!session)
    return session.error();
  return Drawn{std::move(session->picture), session->renderer, session->frames, session->meanSeconds,
               session->longestSeconds};
}

TeResult<Drawn> drawWithoutWindow(SoNode* scene, TeContextKind kind, const TeCommonOptions& options) {
  const TeResult<std::unique_ptr<TeContext>> context = TeContext::create(kind, options.width, options.height);
  if (!context)
    return context.error();
  const auto renderer = TeSceneRenderer::create(**context, options.width, options.height, kSamplesPerPixel);
  if (!renderer)
    return renderer.error();
  Drawn drawn;
  drawn.renderer = (*context)->renderer();
  drawn.frames = std::max(1, options.frames);
  for (int frame = 1; frame <= drawn.frames; ++frame) {
    const TeStopwatch time;
    TeResult<TePicture> picture = (*renderer)->render(scene);
    if (!picture)
      return picture.error();
    const double seconds = time.seconds();
    drawn.meanSeconds += (seconds - drawn.meanSeconds) / frame;
    drawn.longestSeconds = std::max(drawn.longestSeconds, seconds);
    drawn.picture = std::move(*picture);
  }
  return drawn;
}

} // namespace

TeStatus teDrawStatic(SoNode* scene, const TeCommonOptions& options, TeReport& report) {
  const TeResult<TeContextKind> kind = teContextKind(options.context);
  if (!kind)
    return kind.error();
  const TeResult<Drawn> drawn = *kind == TeContextKind::Window ? drawInWindow(scene, options)
                                                               : drawWithoutWindow(scene, *kind, options);
  if (!drawn)
    return drawn.error();
  auto& json = report.json();
  json["context"] = options.context;
  json["renderer"] = drawn->renderer;
  json["frames"] = drawn->frames;
  report.addTime("frame_mean", drawn->meanSeconds);
  report.addTime("frame_longest", drawn->longestSeconds);
  return teKeepPicture(drawn->picture, options, report);
}
