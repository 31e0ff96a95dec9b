#include "nodes/seamless/TeSeamlessViewers.h"

#include "nodes/lod/TeCameraView.h"

#include <Inventor/SbLine.h>
#include <Inventor/actions/SoGLRenderAction.h>
#include <Inventor/elements/SoComplexityElement.h>
#include <Inventor/elements/SoGLCacheContextElement.h>
#include <Inventor/elements/SoModelMatrixElement.h>
#include <Inventor/elements/SoProjectionMatrixElement.h>
#include <Inventor/elements/SoViewingMatrixElement.h>
#include <Inventor/misc/SoState.h>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include <algorithm>
#include <cmath>

namespace {

constexpr double kDefaultViewPixels = 1024;
constexpr double kRayMargin = 1e-6; ///< of what is added in single precision

/// Coin multiplies rows by matrices, glm matrices by columns: the same numbers in memory.
glm::dmat4 toGlm(const SbMatrix& matrix) {
  glm::dmat4 result;
  for (int i = 0; i < 4; i++) {
    for (int j = 0; j < 4; j++)
      result[i][j] = double(matrix[i][j]);
  }
  return result;
}

/// Sees what lies along a line from its beginning on, as sharply as before.
void seeOnly(const SbLine& line, double size, TeLodView& view) {
  const SbVec3f& start = line.getPosition();
  const SbVec3f& ahead = line.getDirection();
  const glm::dvec3 from(start[0], start[1], start[2]);
  const glm::dvec3 along = glm::normalize(glm::dvec3(ahead[0], ahead[1], ahead[2]));
  const glm::dvec3 other = std::abs(along.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 across = glm::normalize(glm::cross(along, other));
  const glm::dvec3 up = glm::cross(along, across);
  const double margin = kRayMargin * (glm::length(from) + size);
  view.planeCount = 0;
  for (const glm::dvec3& normal : {across, -across, up, -up, along})
    view.planes[std::size_t(view.planeCount++)] = glm::dvec4(normal, margin - glm::dot(normal, from));
}

} // namespace

void TeSeamlessViewers::setScene(Scene scene) {
  if (scene.content.terrain != m_scene.content.terrain) {
    m_choices.clear();
    m_drawing =
        std::make_unique<TeSeamlessDrawing>(scene.content.terrain->layout, scene.content.terrain->parts);
  }
  m_scene = std::move(scene);
}

void TeSeamlessViewers::clear() {
  m_choices.clear();
  m_drawing.reset();
  m_scene = {};
  m_statistics = {};
}

SbBox3f TeSeamlessViewers::box() const {
  return TeSeamlessSurface::box(m_scene.placement, m_scene.content.terrain->layout);
}

TeLodView TeSeamlessViewers::defaultView() const {
  const TeSeamlessPlacement& placement = m_scene.placement;
  const double side = placement.spacing * m_scene.content.terrain->layout.resolution();
  const double top = placement.corner.z + double(placement.range.high) * placement.heightScale;
  TeLodView view;
  view.eye = {placement.corner.x + side / 2, placement.corner.y + side / 2, top + side};
  view.focal = kDefaultViewPixels;
  return view;
}

std::optional<TeLodView> TeSeamlessViewers::view(SoState* state) const {
  if (!TeCameraView::hasCamera(state))
    return defaultView();
  return m_scene.lodCamera ? TeCameraView::fromCamera(*m_scene.lodCamera, state)
                           : TeCameraView::fromState(state);
}

TeSeamlessAccuracy TeSeamlessViewers::accuracy(SoState* state) const {
  double complexity = 0.5;
  if (state->isElementEnabled(SoComplexityElement::getClassStackIndex()))
    complexity = std::clamp(double(SoComplexityElement::get(state)), 0.0, 1.0);
  const double factor = std::pow(16.0, complexity - 0.5);
  TeSeamlessAccuracy accuracy = m_scene.accuracy;
  accuracy.precision = std::max(1.0, accuracy.precision * factor);
  accuracy.pixelError /= factor;
  return accuracy;
}

TeStatus TeSeamlessViewers::draw(SoGLRenderAction* action) {
  SoState* state = action->getState();
  const std::optional<TeLodView> seen = view(state);
  m_statistics = {};
  if (!seen)
    return {};
  const std::uint32_t context = std::uint32_t(SoGLCacheContextElement::get(state));
  TeSeamlessChoice& choice = m_choices[context];
  m_lastContext = context;
  const bool isNew =
      choice.update(m_scene.content.terrain, *seen, m_scene.placement, accuracy(state), nullptr);
  const glm::dmat4 fromModel =
      toGlm(SoViewingMatrixElement::get(state)) * toGlm(SoModelMatrixElement::get(state));
  const TeSeamlessFrame frame(m_scene.placement, fromModel, toGlm(SoProjectionMatrixElement::get(state)));
  const TeResult<TeSeamlessCounts> drawn = m_drawing->draw(context, choice.lists(), m_scene.look, frame);
  if (!drawn)
    return drawn.error();
  count(choice, isNew, *drawn);
  return {};
}

void TeSeamlessViewers::count(const TeSeamlessChoice& choice, bool isNew, const TeSeamlessCounts& drawn) {
  const TeSeamlessSelection& selection = choice.selection();
  m_statistics.faces = drawn.triangles;
  m_statistics.drawCalls = drawn.drawCalls;
  m_statistics.traversed = selection.traversed;
  m_statistics.culled = selection.culled;
  m_statistics.rendered = std::int64_t(selection.patches.size());
  m_statistics.bytesUploaded = drawn.bytesUploaded;
  m_statistics.selectionSeconds = isNew ? choice.seconds() : 0;
  m_statistics.errorBound = selection.errorBound;
  m_statistics.precision = selection.precision;
  m_statistics.coarsening = selection.coarsening;
}

TeSeamlessSelection TeSeamlessViewers::selected(SoState* state, const SbLine* along) const {
  TeSeamlessSelection selection;
  const std::optional<TeLodView> seen = view(state);
  if (!seen)
    return selection;
  const TeSeamlessTerrainPtr& terrain = m_scene.content.terrain;
  const TeSeamlessAccuracy wanted = accuracy(state);
  const auto last = m_choices.find(m_lastContext);
  TeLodView held = last == m_choices.end()
                       ? TeSeamlessChoice().held(terrain, *seen, m_scene.placement, wanted)
                       : last->second.held(terrain, *seen, m_scene.placement, wanted);
  if (along)
    seeOnly(*along, m_scene.placement.spacing * terrain->layout.resolution(), held);
  terrain->selector.select(held, m_scene.placement, wanted, nullptr, selection);
  return selection;
}

void TeSeamlessViewers::forEachPatch(const TeSeamlessSelection& selection, const PatchVisitor& visit) const {
  const TeSeamlessMapHeights heights(m_scene.content.terrain->map.get());
  TeSeamlessSurface surface(*m_scene.content.terrain, m_scene.placement, heights);
  for (const TeSeamlessPatch& patch : selection.patches)
    visit(patch, surface);
}
