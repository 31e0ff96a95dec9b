#include "nodes/lod/drawing/TeLodViewers.h"

#include "nodes/TeCoinVectors.h"
#include "nodes/lod/TeActionView.h"
#include "nodes/lod/TeLodMethods.h"
#include "nodes/lod/brute/TeBruteForce.h"

#include <Inventor/SbLine.h>
#include <Inventor/actions/SoGLRenderAction.h>
#include <Inventor/elements/SoGLCacheContextElement.h>
#include <Inventor/misc/SoContextHandler.h>
#include <Inventor/misc/SoState.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cassert>

namespace {

/// The same view in coordinates to which an offset is added.
TeLodView moved(TeLodView view, const glm::dvec3& offset) {
  view.eye += offset;
  for (int i = 0; i < view.planeCount; i++) {
    glm::dvec4& plane = view.planes[std::size_t(i)];
    plane.w -= glm::dot(glm::dvec3(plane), offset);
  }
  return view;
}

} // namespace

TeLodViewers::TeLodViewers() {
  SoContextHandler::addContextDestructionCallback(&TeLodViewers::onContextDestroyed, this);
}

TeLodViewers::~TeLodViewers() {
  SoContextHandler::removeContextDestructionCallback(&TeLodViewers::onContextDestroyed, this);
  releaseAll();
}

void TeLodViewers::onContextDestroyed(std::uint32_t context, void* viewers) {
  auto& all = static_cast<TeLodViewers*>(viewers)->m_viewers;
  for (auto viewer = all.begin(); viewer != all.end();) {
    const bool isThere = viewer->first.first == context;
    if (isThere)
      viewer->second.release(true);
    viewer = isThere ? all.erase(viewer) : std::next(viewer);
  }
}

void TeLodViewers::releaseAll() {
  for (auto& [key, viewer] : m_viewers)
    viewer.release(false);
  m_viewers.clear();
  m_unseen.reset();
  m_allSamples.reset();
  m_spare.reset();
}

TeStatus TeLodViewers::setScene(TeLodScene scene) {
  const bool isSame = m_scene.field && scene.field == m_scene.field && scene.method == m_scene.method;
  m_scene = std::move(scene);
  if (isSame)
    return {};
  releaseAll();
  TeResult<std::unique_ptr<TeLodMethod>> made = TeLodMethods::create(m_scene.method, m_scene.field);
  if (!made) {
    clear();
    return made.error();
  }
  m_spare = std::move(*made);
  m_dial = m_spare->dial();
  return {};
}

void TeLodViewers::clear() {
  releaseAll();
  m_scene = {};
  m_statistics = {};
}

std::unique_ptr<TeLodMethod> TeLodViewers::makeMethod() {
  if (m_spare)
    return std::move(m_spare);
  TeResult<std::unique_ptr<TeLodMethod>> made = TeLodMethods::create(m_scene.method, m_scene.field);
  assert(made); // it was made before
  return std::move(*made);
}

TeLodViewer& TeLodViewers::viewer(const Key& key) {
  auto found = m_viewers.find(key);
  if (found == m_viewers.end()) {
    if (m_viewers.size() >= kMostViewers) {
      const auto oldest =
          std::min_element(m_viewers.begin(), m_viewers.end(),
                           [](const auto& a, const auto& b) { return a.second.lastUse < b.second.lastUse; });
      oldest->second.release(false);
      m_viewers.erase(oldest);
    }
    found = m_viewers.try_emplace(key, makeMethod()).first;
  }
  found->second.lastUse = ++m_uses;
  return found->second;
}

SbBox3f TeLodViewers::box() const {
  const TeLodField& field = *m_scene.field;
  return {teToCoin(field.position(0, 0, double(field.lowest())) + m_scene.offset),
          teToCoin(field.position(field.cells(), field.cells(), double(field.highest())) + m_scene.offset)};
}

std::optional<TeLodView> TeLodViewers::view(SoState* state) const {
  const TeLodField& field = *m_scene.field;
  const glm::dvec3 corner = field.placement().corner + m_scene.offset;
  const double top = corner.z + double(field.highest()) * field.heightScale();
  return TeActionView::view(state, m_scene.lodCamera.get(),
                            TeActionView::fromAbove(corner, field.cells() * field.spacing(), top));
}

std::optional<TeLodView> TeLodViewers::fieldView(SoState* state) const {
  const std::optional<TeLodView> seen = view(state);
  if (!seen)
    return {};
  return moved(*seen, -m_scene.offset);
}

TeLodAccuracy TeLodViewers::accuracy(SoState* state) const {
  const double factor = TeActionView::accuracyFactor(state);
  TeLodAccuracy accuracy = m_scene.accuracy;
  accuracy.pixelError /= factor;
  accuracy.dial *= m_dial.finerIsLarger ? factor : 1 / factor;
  return accuracy;
}

TeStatus TeLodViewers::draw(SoGLRenderAction* action, bool withColours) {
  SoState* state = action->getState();
  m_statistics = {};
  const std::optional<TeLodView> seen = fieldView(state);
  if (!seen)
    return {};
  const std::uint32_t context = std::uint32_t(SoGLCacheContextElement::get(state));
  TeLodViewer& viewer = this->viewer({context, TeActionView::placeOf(action)});
  TeLodRenderer& renderer = viewer.renderer(context);
  if (!renderer.isUsable())
    return TeError{"this OpenGL context cannot draw it"};
  const bool isNew = viewer.choose(*seen, accuracy(state), m_scene.slice);
  const glm::dmat4 eyeFromField = glm::translate(TeActionView::eyeFromModel(state), m_scene.offset);
  TeLodLook look = m_scene.look;
  if (!withColours)
    look.colours.reset();
  count(viewer, renderer.draw(viewer.method(), viewer.selections(), look, eyeFromField));
  m_statistics.selectionSeconds = isNew ? viewer.seconds() : 0;
  return {};
}

void TeLodViewers::count(const TeLodViewer& viewer, const TeLodRenderer::Counts& drawn) {
  const TeLodSelection& selection = viewer.method().selection();
  m_statistics.triangles = drawn.triangles;
  m_statistics.drawCalls = drawn.drawCalls;
  m_statistics.bytesUploaded = drawn.bytesSent;
  m_statistics.keptParts = drawn.keptParts;
  m_statistics.keptBytes = drawn.keptBytes;
  m_statistics.parts = std::int64_t(selection.parts.size());
  m_statistics.visited = selection.visited;
  m_statistics.culled = selection.culled;
  m_statistics.splits = selection.splits;
  m_statistics.merges = selection.merges;
  m_statistics.errorBound = selection.errorBound;
  m_statistics.dial = selection.dial;
  m_statistics.coarsening = selection.coarsening;
  m_statistics.isComplete = selection.complete;
}

const TeLodViewer* TeLodViewers::chosen(SoAction* action) {
  SoState* state = action->getState();
  const std::optional<TeLodView> seen = fieldView(state);
  if (!seen)
    return nullptr;
  const TeLodAccuracy wanted = accuracy(state);
  const std::uint64_t place = TeActionView::placeOf(action);
  const TeLodViewer* last = nullptr;
  bool lastIsThere = false;
  for (const auto& [key, viewer] : m_viewers) {
    const bool isThere = key.second == place;
    if (viewer.hasChosen(*seen, wanted) &&
        (!last || std::pair(isThere, viewer.lastUse) > std::pair(lastIsThere, last->lastUse))) {
      last = &viewer;
      lastIsThere = isThere;
    }
  }
  if (last)
    return last;
  if (!m_unseen)
    m_unseen = std::make_unique<TeLodViewer>(makeMethod());
  m_unseen->choose(*seen, wanted, 0);
  return m_unseen.get();
}

void TeLodViewers::forEachPart(SoAction* action, const MeshVisitor& visit) {
  const TeLodViewer* viewer = chosen(action);
  TeLodMesh mesh;
  for (std::size_t i = 0; viewer && i < viewer->method().selection().parts.size(); i++) {
    mesh.clear();
    viewer->method().appendPart(i, mesh);
    visit(mesh);
  }
}

std::int64_t TeLodViewers::triangles(SoAction* action) {
  const TeLodViewer* viewer = chosen(action);
  return viewer ? viewer->method().selection().triangles : 0;
}

void TeLodViewers::forEachPartAlong(const SbLine& line, const MeshVisitor& visit) {
  if (!m_allSamples)
    m_allSamples = std::make_unique<TeBruteForce>(m_scene.field);
  TeLodView along;
  TeActionView::seeOnly(line, m_scene.field->cells() * m_scene.field->spacing(), along);
  m_allSamples->select(moved(along, -m_scene.offset), TeLodAccuracy());
  TeLodMesh mesh;
  for (std::size_t i = 0; i < m_allSamples->selection().parts.size(); i++) {
    mesh.clear();
    m_allSamples->appendPart(i, mesh);
    visit(mesh);
  }
}
