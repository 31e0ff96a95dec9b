#include "nodes/seamless/TeSeamlessViewers.h"

#include "generators/base/TeHash.h"
#include "nodes/lod/TeCameraView.h"
#include "nodes/seamless/TeSeamlessRenderer.h"

#include <Inventor/SbLine.h>
#include <Inventor/SoPath.h>
#include <Inventor/actions/SoGLRenderAction.h>
#include <Inventor/elements/SoComplexityElement.h>
#include <Inventor/elements/SoGLCacheContextElement.h>
#include <Inventor/elements/SoModelMatrixElement.h>
#include <Inventor/elements/SoProjectionMatrixElement.h>
#include <Inventor/elements/SoViewingMatrixElement.h>
#include <Inventor/misc/SoContextHandler.h>
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

/// The place in the scene that an action has come to. Coin means any path to be looked at as a full one,
/// which the sanitizer does not know.
__attribute__((no_sanitize("vptr"))) std::uint64_t placeOf(SoAction* action) {
  const auto* path = static_cast<const SoFullPath*>(action->getCurPath());
  std::uint64_t hash = 0;
  for (int i = 0; path && i < path->getLength(); i++) {
    const std::int32_t index = path->getIndex(i);
    hash = teHashBytes(&index, sizeof index, hash);
  }
  return hash;
}

} // namespace

TeSeamlessViewers::TeSeamlessViewers() {
  SoContextHandler::addContextDestructionCallback(&TeSeamlessViewers::onContextDestroyed, this);
}

TeSeamlessViewers::~TeSeamlessViewers() {
  SoContextHandler::removeContextDestructionCallback(&TeSeamlessViewers::onContextDestroyed, this);
  releaseAll();
}

void TeSeamlessViewers::onContextDestroyed(std::uint32_t context, void* viewers) {
  auto& all = static_cast<TeSeamlessViewers*>(viewers)->m_viewers;
  for (auto viewer = all.begin(); viewer != all.end();) {
    const bool isThere = viewer->first.first == context;
    if (isThere)
      viewer->second.release(true);
    viewer = isThere ? all.erase(viewer) : std::next(viewer);
  }
}

void TeSeamlessViewers::releaseAll() {
  for (auto& [key, viewer] : m_viewers)
    viewer.release(false);
  m_viewers.clear();
  m_unseen = {};
}

void TeSeamlessViewers::setScene(TeSeamlessScene scene) {
  if (scene.content.terrain != m_scene.content.terrain || scene.colours.get() != m_scene.colours.get() ||
      scene.colourTiles != m_scene.colourTiles)
    releaseAll();
  const TeSeamlessTerrain& terrain = *scene.content.terrain;
  const auto& parts = scene.wholePatches ? terrain.wholePatches() : terrain.parts;
  if (parts != m_parts)
    m_drawing = std::make_unique<TeSeamlessDrawing>(terrain.layout, parts);
  m_parts = parts;
  m_scene = std::move(scene);
}

void TeSeamlessViewers::clear() {
  releaseAll();
  m_drawing.reset();
  m_parts.reset();
  m_scene = {};
  m_statistics = {};
  m_isWaiting = false;
}

TeSeamlessViewer& TeSeamlessViewers::viewer(const Key& key) {
  if (m_viewers.size() >= kMostViewers && m_viewers.count(key) == 0) {
    const auto oldest =
        std::min_element(m_viewers.begin(), m_viewers.end(),
                         [](const auto& a, const auto& b) { return a.second.lastUse < b.second.lastUse; });
    oldest->second.release(false);
    m_viewers.erase(oldest);
  }
  TeSeamlessViewer& viewer = m_viewers[key];
  viewer.lastUse = ++m_uses;
  return viewer;
}

TeSeamlessViewer* TeSeamlessViewers::lastViewer(SoAction* action) {
  const std::uint64_t place = placeOf(action);
  TeSeamlessViewer* last = nullptr;
  bool lastIsThere = false;
  for (auto& [key, viewer] : m_viewers) {
    const bool isThere = key.second == place;
    if (!last || std::pair(isThere, viewer.lastUse) > std::pair(lastIsThere, last->lastUse)) {
      last = &viewer;
      lastIsThere = isThere;
    }
  }
  return last;
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
  if (m_scene.content.clipmap)
    accuracy.rounding = double(teDrawnRounding(m_scene.content.clipmap->getFormat()));
  return accuracy;
}

TeStatus TeSeamlessViewers::draw(SoGLRenderAction* action) {
  SoState* state = action->getState();
  const std::optional<TeLodView> seen = view(state);
  m_statistics = {};
  m_isWaiting = false;
  if (!seen)
    return {};
  const std::uint32_t context = std::uint32_t(SoGLCacheContextElement::get(state));
  TeSeamlessViewer& viewer = this->viewer({context, placeOf(action)});
  const std::int64_t uploaded = viewer.bytesUploaded();
  const std::uint64_t selections = viewer.choice.selections();
  if (TeStatus status = viewer.follow(m_scene, context, seen->eye, true); !status)
    return status;
  if (TeStatus status = viewer.upload(); !status)
    return status;
  viewer.choice.update(m_scene.content.terrain, m_parts, *seen, m_scene.placement, accuracy(state),
                       viewer.residency());
  const glm::dmat4 fromModel =
      toGlm(SoViewingMatrixElement::get(state)) * toGlm(SoModelMatrixElement::get(state));
  TeSeamlessFrame frame(m_scene.placement, fromModel, toGlm(SoProjectionMatrixElement::get(state)));
  frame.heightClipmap = viewer.heights ? &viewer.heights->texture() : nullptr;
  frame.colourClipmap = viewer.colours ? &viewer.colours->texture() : nullptr;
  TeResult<TeSeamlessCounts> drawn = m_drawing->draw(context, viewer.choice.lists(), m_scene.look, frame);
  if (!drawn)
    return drawn.error();
  drawn->bytesUploaded += viewer.bytesUploaded() - uploaded;
  count(viewer, *drawn);
  if (viewer.choice.selections() == selections)
    m_statistics.selectionSeconds = 0;
  m_statistics.programs = m_drawing->renderer(context)->programsCompiled();
  m_isWaiting = !viewer.isSettled();
  return {};
}

void TeSeamlessViewers::count(const TeSeamlessViewer& viewer, const TeSeamlessCounts& drawn) {
  const TeSeamlessSelection& selection = viewer.choice.selection();
  const TeSeamlessTerrain& terrain = *m_scene.content.terrain;
  m_statistics.faces = drawn.triangles;
  m_statistics.drawCalls = drawn.drawCalls;
  m_statistics.traversed = selection.traversed;
  m_statistics.culled = selection.culled;
  m_statistics.rendered = std::int64_t(selection.patches.size());
  m_statistics.bytesUploaded = drawn.bytesUploaded;
  m_statistics.selectionSeconds = viewer.choice.seconds();
  // Flat ground has no error, whatever it is drawn with.
  m_statistics.errorBound = m_scene.content.isFlat() ? 0 : selection.errorBound;
  m_statistics.precision = selection.precision;
  m_statistics.coarsening = selection.coarsening;
  m_statistics.heightBytes = terrain.map ? terrain.map->bytes() : 0;
  if (viewer.heights) {
    const TeClipWindows& windows = viewer.heights->windows();
    m_statistics.heightBytes = windows.imageBytes() * std::size_t(windows.levels());
    m_statistics.clipTextureBytes = viewer.heights->textureBytes();
  }
  if (viewer.colours)
    m_statistics.clipTextureBytes += viewer.colours->textureBytes();
}

TeSeamlessViewer* TeSeamlessViewers::select(SoAction* action, const SbLine* along,
                                            TeSeamlessSelection& selection) {
  SoState* state = action->getState();
  const std::optional<TeLodView> seen = view(state);
  if (!seen)
    return nullptr;
  TeSeamlessViewer* viewer = lastViewer(action);
  if (!viewer) {
    viewer = &m_unseen;
    if (!viewer->follow(m_scene, 0, seen->eye, false))
      return nullptr;
  }
  if (m_scene.content.clipmap && !viewer->heights)
    return nullptr; // nothing was drawn: they could not be read
  const TeSeamlessTerrainPtr& terrain = m_scene.content.terrain;
  const TeSeamlessAccuracy wanted = accuracy(state);
  TeLodView held = viewer->choice.held(terrain, *seen, m_scene.placement, wanted);
  if (along)
    seeOnly(*along, m_scene.placement.spacing * terrain->layout.resolution(), held);
  terrain->selector.select(held, m_scene.placement, wanted, viewer->residency(), selection);
  return viewer;
}

void TeSeamlessViewers::forEachPatch(SoAction* action, const SbLine* along, const PatchVisitor& visit) {
  TeSeamlessSelection selection;
  const TeSeamlessViewer* viewer = select(action, along, selection);
  if (!viewer)
    return;
  const TeSeamlessTerrain& terrain = *m_scene.content.terrain;
  std::unique_ptr<TeSeamlessHeights> heights;
  if (viewer->heights)
    heights = std::make_unique<TeSeamlessClipHeights>(viewer->heights->windows(), viewer->heights->format(),
                                                      terrain.layout.resolutionLog());
  else
    heights = std::make_unique<TeSeamlessMapHeights>(terrain.map.get());
  TeSeamlessSurface surface(terrain, m_scene.placement, *heights);
  for (const TeSeamlessPatch& patch : selection.patches)
    visit(patch, surface);
}

std::int64_t TeSeamlessViewers::triangles(SoAction* action) {
  TeSeamlessSelection selection;
  select(action, nullptr, selection);
  return selection.triangles;
}
