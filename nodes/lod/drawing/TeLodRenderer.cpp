#include "nodes/lod/drawing/TeLodRenderer.h"

#include <glm/common.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace {

bool isFinite(const glm::dmat4& matrix) {
  double sum = 0;
  for (int column = 0; column < 4; column++)
    for (int row = 0; row < 4; row++)
      sum += matrix[column][row];
  return std::isfinite(sum);
}

} // namespace

void TeLodRenderer::freeAll() {
  m_parts.clear();
  m_sender.freeStream();
  m_hasAnchor = false;
  m_selection = 0;
  m_keepsNew = true;
  m_newKeys.clear();
  m_sentOnce.clear();
  m_onceCount = 0;
}

void TeLodRenderer::placeAnchor(const TeLodField& field, const glm::dvec3& eye) {
  const double reach = kReach * field.spacing();
  const glm::dvec3 low = field.position(0, 0, double(field.lowest()));
  const glm::dvec3 high = field.position(field.cells(), field.cells(), double(field.highest()));
  const glm::dvec3 nearest = glm::clamp(eye, low, high);
  const glm::dvec3 away = glm::abs(nearest - m_anchor);
  if (m_hasAnchor && std::max({away.x, away.y, away.z}) <= reach)
    return;
  freeAll();
  m_anchor = nearest;
  m_hasAnchor = true;
}

/// Whether those that were new in the selection before have stayed.
void TeLodRenderer::learn(const TeLodSelection& selection) {
  if (m_newKeys.empty())
    return;
  std::size_t stayed = 0;
  for (const TeLodPart& part : selection.parts)
    stayed += m_newKeys.count(part.key);
  m_keepsNew = 2 * stayed >= m_newKeys.size();
}

TeLodRenderer::Counts TeLodRenderer::draw(const TeLodMethod& method, std::uint64_t selection,
                                          const TeLodLook& look, const glm::dmat4& eyeFromField) {
  const glm::dmat3 turned(eyeFromField);
  const double determinant = glm::determinant(turned);
  if (!m_isUsable || !isFinite(eyeFromField) || determinant == 0 || !std::isfinite(determinant))
    return {};
  if (look.submission != m_submission || look.colours.has_value() != m_hasColours)
    freeAll();
  m_submission = look.submission;
  m_hasColours = look.colours.has_value();
  placeAnchor(method.field(), glm::inverse(turned) * -glm::dvec3(eyeFromField[3]));

  const std::int64_t bytes = m_sender.bytesSent();
  const std::int64_t calls = m_sender.drawCalls();
  GLint mode = 0, polygons[2] = {};
  GLfloat matrix[16] = {};
  m_gl.getIntegerv(GL_MATRIX_MODE, &mode);
  m_gl.getFloatv(GL_MODELVIEW_MATRIX, matrix);
  m_gl.getIntegerv(GL_POLYGON_MODE, polygons);
  m_gl.matrixMode(GL_MODELVIEW);
  m_gl.loadMatrixd(glm::value_ptr(glm::translate(eyeFromField, m_anchor)));
  if (look.wireframe)
    m_gl.polygonMode(GL_FRONT_AND_BACK, GL_LINE);
  m_sender.begin(look.submission, m_hasColours);
  sendParts(method, look, selection != m_selection);
  m_sender.end();
  m_selection = selection;
  if (look.wireframe) {
    m_gl.polygonMode(GL_FRONT, GLenum(polygons[0]));
    m_gl.polygonMode(GL_BACK, GLenum(polygons[1]));
  }
  m_gl.loadMatrixf(matrix);
  m_gl.matrixMode(GLenum(mode));
  return {method.selection().triangles, m_sender.drawCalls() - calls, m_sender.bytesSent() - bytes,
          std::int64_t(m_parts.size()), m_parts.bytes()};
}

void TeLodRenderer::sendParts(const TeLodMethod& method, const TeLodLook& look, bool isNewSelection) {
  const TeLodSelection& selection = method.selection();
  if (!isNewSelection && m_submission == TeLodSubmission::VboStream) {
    m_sender.drawOnce(m_once, m_onceCount);
    return;
  }
  const TeLodArrayMaker maker(method.field(), m_anchor, look.colours ? &*look.colours : nullptr);
  if (isNewSelection)
    learn(selection);
  const std::unordered_set<std::uint64_t> sentBefore = std::move(m_sentOnce);
  m_sentOnce.clear();
  if (isNewSelection)
    m_newKeys.clear();
  m_onceCount = 0;
  m_parts.beginFrame();
  for (std::size_t i = 0; i < selection.parts.size(); i++) {
    const std::uint64_t key = selection.parts[i].key;
    if (const TeLodSender::Kept* kept = m_parts.find(key)) {
      m_sender.draw(*kept);
      continue;
    }
    m_mesh.clear();
    method.appendPart(i, m_mesh);
    const bool isAgain = sentBefore.count(key) > 0;
    if (isNewSelection && !isAgain)
      m_newKeys.insert(key);
    if (m_onceCount == m_once.size())
      m_once.emplace_back();
    TeLodArrays& arrays = m_once[m_onceCount];
    maker.make(m_mesh, arrays);
    const bool stays = m_sender.keepsParts() && (m_keepsNew || isAgain);
    if (const TeLodSender::Kept* kept = stays ? m_parts.add(key, arrays) : nullptr) {
      m_sender.draw(*kept);
      continue;
    }
    m_onceCount++;
    m_sentOnce.insert(key);
  }
  m_sender.drawOnce(m_once, m_onceCount);
}
