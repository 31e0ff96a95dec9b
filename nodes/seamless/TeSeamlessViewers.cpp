#include "nodes/seamless/TeSeamlessViewers.h"

#include "nodes/lod/TeActionView.h"
#include "nodes/seamless/TeSeamlessRenderer.h"

#include <Inventor/actions/SoGLRenderAction.h>
#include <Inventor/elements/SoGLCacheContextElement.h>
#include <Inventor/misc/SoContextHandler.h>
#include <Inventor/misc/SoState.h>

#include <algorithm>

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
  const std::uint64_t place = TeActionView::placeOf(action);
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

std::optional<TeLodView> TeSeamlessViewers::view(SoState* state) const {
  const TeSeamlessPlacement& placement = m_scene.placement;
  const double side = placement.spacing * m_scene.content.terrain->layout.resolution();
  const double top = placement.corner.z + double(placement.range.high) * placement.heightScale;
  return TeActionView::view(state, m_scene.lodCamera.get(),
                            TeActionView::fromAbove(placement.corner, side, top));
}

TeSeamlessAccuracy TeSeamlessViewers::accuracy(SoState* state) const {
  const double factor = TeActionView::accuracyFactor(state);
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
  TeSeamlessViewer& viewer = this->viewer({context, TeActionView::placeOf(action)});
  const std::int64_t uploaded = viewer.bytesUploaded();
  const std::uint64_t selections = viewer.choice.selections();
  if (TeStatus status = viewer.follow(m_scene, context, seen->eye, true); !status)
    return status;
  if (TeStatus status = viewer.upload(); !status)
    return status;
  viewer.choice.update(m_scene.content.terrain, m_parts, *seen, m_scene.placement, accuracy(state),
                       viewer.residency());
  TeSeamlessFrame frame(m_scene.placement, TeActionView::eyeFromModel(state),
                        TeActionView::projection(state));
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
    TeActionView::seeOnly(*along, m_scene.placement.spacing * terrain->layout.resolution(), held);
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
