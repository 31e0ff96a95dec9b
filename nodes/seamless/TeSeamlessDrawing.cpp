#include "nodes/seamless/TeSeamlessDrawing.h"

#include "nodes/seamless/TeSeamlessRenderer.h"

#include <Inventor/elements/SoGLCacheContextElement.h>
#include <Inventor/misc/SoContextHandler.h>

TeSeamlessDrawing::TeSeamlessDrawing(const TeSeamlessLayout& layout,
                                     std::shared_ptr<const TeSeamlessParts> parts)
    : m_layout(layout), m_parts(std::move(parts)) {
  SoContextHandler::addContextDestructionCallback(&TeSeamlessDrawing::onContextDestroyed, this);
}

TeSeamlessDrawing::~TeSeamlessDrawing() {
  SoContextHandler::removeContextDestructionCallback(&TeSeamlessDrawing::onContextDestroyed, this);
  for (const auto& [context, renderer] : m_renderers)
    freeWhenCurrent(renderer);
}

TeResult<TeSeamlessCounts> TeSeamlessDrawing::draw(std::uint32_t context, const TeSeamlessLists& lists,
                                                   const TeSeamlessLook& look, const TeSeamlessFrame& frame) {
  std::shared_ptr<TeSeamlessRenderer>& renderer = m_renderers[context];
  if (!renderer)
    renderer = std::make_shared<TeSeamlessRenderer>(context, m_layout, m_parts);
  return renderer->draw(lists, look, frame);
}

TeSeamlessRenderer* TeSeamlessDrawing::renderer(std::uint32_t context) {
  const auto found = m_renderers.find(context);
  return found == m_renderers.end() ? nullptr : found->second.get();
}

void TeSeamlessDrawing::freeWhenCurrent(const std::shared_ptr<TeSeamlessRenderer>& renderer) {
  SoGLCacheContextElement::scheduleDeleteCallback(
      renderer->context(),
      [](void* closure, std::uint32_t) {
        const std::unique_ptr<std::shared_ptr<TeSeamlessRenderer>> held(
            static_cast<std::shared_ptr<TeSeamlessRenderer>*>(closure));
        (*held)->freeAll();
      },
      new std::shared_ptr<TeSeamlessRenderer>(renderer));
}

void TeSeamlessDrawing::onContextDestroyed(std::uint32_t context, void* drawing) {
  auto& all = static_cast<TeSeamlessDrawing*>(drawing)->m_renderers;
  const auto found = all.find(context);
  if (found == all.end())
    return;
  found->second->freeAll();
  all.erase(found);
}
