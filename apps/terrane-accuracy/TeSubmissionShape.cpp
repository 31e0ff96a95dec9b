#include "apps/terrane-accuracy/TeSubmissionShape.h"

#include <Inventor/actions/SoGLRenderAction.h>
#include <Inventor/elements/SoCacheElement.h>
#include <Inventor/elements/SoGLCacheContextElement.h>
#include <Inventor/elements/SoGLLazyElement.h>
#include <Inventor/misc/SoState.h>

TeSubmissionShape::TeSubmissionShape(const std::vector<TeLodArrays>& parts, TeLodSubmission way, bool changes)
    : m_node(new SoCallback), m_parts(parts), m_way(way), m_changes(changes) {
  m_node->setCallback(&TeSubmissionShape::onDraw, this);
  if (way == TeLodSubmission::VertexArrays)
    for (TeLodArrays& part : m_parts)
      TeLodArrayMaker::expand(part);
}

TeSubmissionShape::~TeSubmissionShape() {
  m_node->setCallback(nullptr);
  if (!m_sender)
    return;
  freeKept();
  m_sender->freeStream();
}

std::size_t TeSubmissionShape::bytes() const {
  std::size_t bytes = 0;
  for (const TeLodArrays& part : m_parts)
    bytes += part.bytes();
  return bytes;
}

void TeSubmissionShape::onDraw(void* shape, SoAction* action) {
  if (!action->isOfType(SoGLRenderAction::getClassTypeId()))
    return;
  SoState* state = action->getState();
  SoCacheElement::invalidate(state);
  SoGLLazyElement::getInstance(state)->send(state, SoLazyElement::ALL_MASK);
  static_cast<TeSubmissionShape*>(shape)->draw(std::uint32_t(SoGLCacheContextElement::get(state)));
}

void TeSubmissionShape::freeKept() {
  for (const TeLodSender::Kept& part : m_kept)
    m_sender->free(part);
  m_kept.clear();
}

void TeSubmissionShape::change() {
  if (!m_changes)
    return;
  const float step = m_frame++ % 2 == 0 ? 0.25f : -0.25f;
  for (TeLodArrays& part : m_parts)
    for (TeDrawnVertex& vertex : part.vertices)
      vertex.position[2] += step;
}

void TeSubmissionShape::draw(std::uint32_t context) {
  if (!m_sender) {
    m_isUsable = m_gl.load(context);
    m_sender = std::make_unique<TeLodSender>(m_gl);
  }
  if (!m_isUsable)
    return;
  const std::int64_t bytes = m_sender->bytesSent(), calls = m_sender->drawCalls();
  m_sender->begin(m_way, false);
  // Buffers that are meant to be changed stay, with new contents; static ones and lists are made anew. Other
  // ways send from here.
  const bool keeps = m_way == TeLodSubmission::VboStatic || m_way == TeLodSubmission::DisplayLists ||
                     (m_way == TeLodSubmission::VboDynamic && !m_changes);
  if (keeps) {
    if (m_changes)
      freeKept();
    for (std::size_t i = m_kept.size(); i < m_parts.size(); i++) {
      TeLodArrays copy = m_parts[i];
      m_kept.push_back(m_sender->keep(std::move(copy)));
    }
    for (const TeLodSender::Kept& part : m_kept)
      m_sender->draw(part);
  } else {
    m_sender->drawOnce(m_parts, m_parts.size());
  }
  m_sender->end();
  m_bytes = m_sender->bytesSent() - bytes;
  m_calls = m_sender->drawCalls() - calls;
}
