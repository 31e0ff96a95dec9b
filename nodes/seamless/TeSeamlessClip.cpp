#include "nodes/seamless/TeSeamlessClip.h"

#include <Inventor/elements/SoGLCacheContextElement.h>

#include <utility>

TeResult<std::shared_ptr<TeSeamlessClip>> TeSeamlessClip::create(SoTeClipmap* node, std::uint32_t context,
                                                                 int highest) {
  TeResult<std::unique_ptr<TeClipWindows>> windows = node->makeWindows(highest);
  if (!windows)
    return windows.error();
  std::shared_ptr<TeSeamlessClip> clip(new TeSeamlessClip);
  clip->m_node = node;
  clip->m_context = context;
  clip->m_level = highest >= 0 ? highest : (*windows)->topLevel();
  clip->m_windows = std::move(*windows);
  clip->makeTexture();
  return clip;
}

void TeSeamlessClip::makeTexture() {
  m_texture = std::make_unique<TeClipmapTexture>(m_context, m_node->getFormat());
}

void TeSeamlessClip::follow(glm::dvec2 centre, bool inBudget) {
  const double samples = double(std::int64_t(1) << m_level);
  m_windows->update(centre * samples, m_level, inBudget ? m_node->getUploadBudget() : 0);
}

TeStatus TeSeamlessClip::upload() {
  if (m_texture->format() != m_node->getFormat()) {
    m_texture->free();
    makeTexture();
  }
  if (TeStatus status = m_texture->update(*m_windows); !status)
    return status;
  m_shown = TeSeamlessClipTexture::of(*m_texture, *m_windows, m_level);
  return {};
}

void TeSeamlessClip::release(const std::shared_ptr<TeSeamlessClip>& clip) {
  SoGLCacheContextElement::scheduleDeleteCallback(
      clip->m_context,
      [](void* closure, std::uint32_t) {
        const std::unique_ptr<std::shared_ptr<TeSeamlessClip>> held(
            static_cast<std::shared_ptr<TeSeamlessClip>*>(closure));
        (*held)->free();
      },
      new std::shared_ptr<TeSeamlessClip>(clip));
}
