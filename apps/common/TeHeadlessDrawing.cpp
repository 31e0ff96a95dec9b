#include "apps/common/TeHeadlessDrawing.h"

namespace {

constexpr int kSamplesPerPixel = 4; ///< of pictures that are kept

} // namespace

TeResult<TeHeadlessDrawing> TeHeadlessDrawing::create(const TeCommonOptions& common, SoNode& scene,
                                                      const SbColor& background) {
  const TeResult<TeContextKind> kind = teContextKind(common.context);
  if (!kind)
    return kind.error();
  TeResult<std::unique_ptr<TeContext>> context = TeContext::create(*kind, common.width, common.height);
  if (!context)
    return context.error();
  TeHeadlessDrawing drawing(std::move(*context), common, scene, background);
  TeResult<Renderer> frames = drawing.renderer(1);
  if (!frames)
    return frames.error();
  drawing.m_frames = std::move(*frames);
  return drawing;
}

TeResult<TeHeadlessDrawing::Renderer> TeHeadlessDrawing::renderer(int samples) const {
  TeResult<Renderer> renderer =
      TeSceneRenderer::create(*m_context, m_context->width(), m_context->height(), samples);
  if (renderer) {
    (*renderer)->setFitClipPlanes(false);
    (*renderer)->setBackground(m_background);
  }
  return renderer;
}

TeResult<TePicture> TeHeadlessDrawing::picture() const {
  const TeResult<Renderer> fine = renderer(kSamplesPerPixel);
  if (!fine)
    return fine.error();
  return (*fine)->render(&m_scene);
}

void TeHeadlessDrawing::describe(TeReport& report) const {
  report.json()["context"] = m_common.context;
  report.json()["renderer"] = m_context->renderer();
}
