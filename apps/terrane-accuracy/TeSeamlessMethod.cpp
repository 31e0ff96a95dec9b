#include "apps/terrane-accuracy/TeSeamlessMethod.h"

#include <cassert>

TeResult<std::unique_ptr<TeSeamlessMethod>> TeSeamlessMethod::create(const TeMeasuredTerrain& terrain,
                                                                     const Settings& settings) {
  const TeResult<TeSeamlessLayout> layout =
      TeSeamlessLayout::create(terrain.cells(), settings.minResolution, settings.levels);
  if (!layout)
    return layout.error();
  TeResult<std::shared_ptr<const TeSeamlessBounds>> bounds =
      TeSeamlessBounds::create(*layout, terrain.heights);
  if (!bounds)
    return bounds.error();
  return std::unique_ptr<TeSeamlessMethod>(new TeSeamlessMethod(terrain, settings, std::move(*bounds)));
}

TeSeamlessMethod::TeSeamlessMethod(const TeMeasuredTerrain& terrain, const Settings& settings,
                                   std::shared_ptr<const TeSeamlessBounds> bounds)
    : m_terrain(terrain), m_settings(settings), m_name(settings.geomorph ? "seamless-geomorph" : "seamless"),
      m_selector(bounds->layout(), bounds), m_parts(bounds->layout(), true) {
  const TeMapStatistics statistics = terrain.heights.statistics();
  m_placement.spacing = terrain.spacing;
  m_placement.heightScale = terrain.heightScale;
  m_placement.range = {statistics.minimum, statistics.maximum};
}

double TeSeamlessMethod::bytesPerSample() const {
  const TeSeamlessLayout& layout = m_selector.layout();
  const double samples = double(m_terrain.heights.width()) * double(m_terrain.heights.height());
  const double parts = double(m_parts.vertices().size() * sizeof(TePartVertex) +
                              m_parts.indices().size() * sizeof(std::uint16_t));
  // A texture of 16 bits, the parts, and the bounds of TeSeamlessBounds.
  const double bounds = double(layout.patchCount()) * (8.0 * (layout.levels() + 5) + 8.0);
  return 2 + (parts + bounds) / samples;
}

void TeSeamlessMethod::select(const TeLodView& view, const TeDial& dial) {
  TeSeamlessAccuracy accuracy;
  accuracy.pixelError = dial.pixels;
  accuracy.precision = dial.pixels > 0 ? 1 : dial.own;
  accuracy.geomorph = m_settings.geomorph;
  m_dial = dial;
  m_selector.select(view, m_placement, accuracy, nullptr, m_selection);
  m_lists.build(m_selection, m_selector.layout(), m_parts);
}

TeSelected TeSeamlessMethod::selected() const {
  TeSelected selected;
  selected.triangles = m_selection.triangles;
  selected.visited = m_selection.traversed;
  selected.parts = std::int64_t(m_selection.patches.size());
  selected.drawCalls = std::int64_t(m_lists.draws().size());
  selected.uploadBytes = std::int64_t(m_lists.instances().size() * sizeof(TeSeamlessInstance));
  selected.boundPixels = m_selection.errorBound;
  selected.dial = m_dial.pixels > 0 ? m_selection.precision : m_dial.own;
  return selected;
}

void TeSeamlessMethod::appendMesh(std::vector<TeSeamlessMesh::Triangle>& triangles) const {
  const TeSeamlessMapHeights heights(&m_terrain.heights);
  for (const TeSeamlessPatch& patch : m_selection.patches)
    TeSeamlessMesh::appendPatch(patch, m_selector.layout(), m_parts, heights, triangles);
}

SoNode* TeSeamlessMethod::node(const TeDial& dial) {
  if (!m_node) {
    m_node = TeNodePtr<SoTeSeamlessPatches>(new SoTeSeamlessPatches);
    TeHeightMap metres = m_terrain.heights;
    const TeStatus scaled = metres.scale(float(m_terrain.heightScale), metres.bounds());
    assert(scaled);
    const double side = m_terrain.spacing * m_terrain.cells();
    m_node->size.setValue(float(side), float(side), 1);
    m_node->center.setValue(0.5 * side, 0.5 * side, 0);
    m_node->resolution = m_terrain.cells();
    m_node->minPatchResolution = m_settings.minResolution;
    m_node->levels = m_settings.levels;
    m_node->geomorph = m_settings.geomorph;
    m_node->heightSource = SoTeSeamlessPatches::HEIGHTMAP;
    m_node->stripColor.setValue(1, 1, 1);
    m_node->setHeights(std::make_shared<const TeHeightMap>(std::move(metres)));
  }
  m_node->pixelError = float(dial.pixels);
  m_node->precision = dial.pixels > 0 ? 1.0f : float(dial.own);
  return m_node.get();
}
