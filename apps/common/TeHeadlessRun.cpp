#include "apps/common/TeHeadlessRun.h"

#include "apps/common/TeProgressLine.h"
#include "generators/base/TeAllowance.h"
#include "generators/base/TeText.h"
#include "nodes/TeSceneRenderer.h"

#include <algorithm>
#include <chrono>

namespace {

constexpr int kSamplesPerPixel = 4; ///< of pictures that are kept

double wallSeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

using Renderer = std::unique_ptr<TeSceneRenderer>;

TeResult<Renderer> rendererOf(TeContext& context, TeEngineStage& stage, int samples) {
  TeResult<Renderer> renderer = TeSceneRenderer::create(context, context.width(), context.height(), samples);
  if (renderer) {
    (*renderer)->setFitClipPlanes(false); // the engine sees to them
    (*renderer)->setBackground(stage.background());
  }
  return renderer;
}

/// The frames of a run, all but the final picture.
class Frames {
public:
  Frames(TeEngineSession& session, TeContext& context) : m_session(session), m_context(context) {}

  TeStatus run() {
    TeResult<Renderer> fast = rendererOf(m_context, m_session.stage(), 1);
    if (!fast)
      return fast.error();
    m_renderer = std::move(*fast);
    TeProgressLine progress("Running", m_session.common().quiet);
    const int frames = std::max(1, m_session.frames());
    m_last = wallSeconds();
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
    const double now = wallSeconds();
    if (!engine.timeTick(m_session.beforeTick(now - m_last)))
      return TeError{engine.lastError()};
    m_last = now;
    ++m_count;
    if (const TeStatus ok = m_session.afterTick(); !ok)
      return ok;
    if (engine.needsRedraw() || m_drawn == 0)
      if (const TeStatus ok = draw(); !ok)
        return ok;
    if (m_session.takePictureWanted())
      return takePicture();
    return {};
  }

  TeStatus draw() {
    const double begin = wallSeconds(), before = teThreadCpuSeconds();
    if (const TeStatus ok = m_renderer->draw(&m_session.stage().all()); !ok)
      return ok;
    ++m_drawn;
    const double finishSeconds = wallSeconds() - begin;
    m_drawSeconds += finishSeconds;
    // Frames of a run that repeats have the time that they simulate: what the HUD shows repeats, too.
    const double dt = m_session.common().dt;
    if (dt > 0)
      m_session.engine().frameDrawn(dt, 0);
    else
      m_session.engine().frameDrawn(begin - m_lastFrame, teThreadCpuSeconds() - before, finishSeconds);
    m_lastFrame = begin;
    m_session.log().drawn(m_session.engine());
    return {};
  }

  TeStatus takePicture() {
    const TeResult<Renderer> fine = rendererOf(m_context, m_session.stage(), kSamplesPerPixel);
    if (!fine)
      return fine.error();
    m_session.savePicture((*fine)->render(&m_session.stage().all()));
    return {};
  }

  TeEngineSession& m_session;
  TeContext& m_context;
  Renderer m_renderer;
  int m_count = 0;
  int m_drawn = 0;
  double m_drawSeconds = 0;
  double m_last = 0;
  double m_lastFrame = wallSeconds();
};

TeResult<TePicture> finalPicture(TeEngineSession& session, TeContext& context) {
  session.engine().finishJobs();
  const TeResult<Renderer> fine = rendererOf(context, session.stage(), kSamplesPerPixel);
  if (!fine)
    return fine.error();
  return (*fine)->render(&session.stage().all());
}

} // namespace

TeStatus teRunHeadless(TeEngineSession& session, TeReport& report) {
  const TeCommonOptions& common = session.common();
  const TeResult<TeContextKind> kind = teContextKind(common.context);
  if (!kind)
    return kind.error();
  const auto context = TeContext::create(*kind, common.width, common.height);
  if (!context)
    return context.error();
  Frames frames(session, **context);
  if (const TeStatus ok = frames.run(); !ok)
    return ok;
  const TeResult<TePicture> picture = finalPicture(session, **context);
  if (!picture)
    return picture.error();
  auto& json = report.json();
  json["context"] = common.context;
  json["renderer"] = (*context)->renderer();
  json["frames"] = frames.count();
  json["frames_drawn"] = frames.drawn();
  report.addTime("frame_mean", frames.meanSeconds());
  json["state_hash"] = teHexText(session.engine().stateHash(true));
  report.addPicture(*picture);
  return common.offscreen.empty() ? TeStatus() : picture->writePng(common.offscreen);
}
