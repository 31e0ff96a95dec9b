#include "nodes/seamless/TeSeamlessTerrain.h"

#include <utility>

const std::shared_ptr<const TeSeamlessParts>& TeSeamlessTerrain::wholePatches() const {
  std::call_once(m_wholePatchesOnce,
                 [this] { m_wholePatches = std::make_shared<const TeSeamlessParts>(layout, true); });
  return m_wholePatches;
}

TeSeamlessTerrainPtr TeSeamlessTerrain::flat(const TeSeamlessLayout& layout) {
  return TeSeamlessTerrainPtr(new TeSeamlessTerrain(layout, nullptr));
}

TeResult<TeSeamlessTerrainPtr> TeSeamlessTerrain::create(const TeSeamlessLayout& layout,
                                                         std::shared_ptr<const TeHeightMap> map) {
  TeResult<std::shared_ptr<const TeSeamlessBounds>> bounds = TeSeamlessBounds::create(layout, *map);
  if (!bounds)
    return bounds.error();
  const TeHeightRange range = (*bounds)->range(0, 0, 0);
  std::shared_ptr<TeSeamlessTerrain> terrain(new TeSeamlessTerrain(layout, std::move(*bounds)));
  terrain->range = range;
  terrain->map = std::move(map);
  return TeSeamlessTerrainPtr(std::move(terrain));
}

TeSeamlessTerrainPtr TeSeamlessTerrain::create(const TeSeamlessLayout& layout,
                                               std::shared_ptr<const TeSeamlessBounds> bounds,
                                               TeHeightRange range) {
  if (bounds)
    range = bounds->range(0, 0, 0);
  std::shared_ptr<TeSeamlessTerrain> terrain(new TeSeamlessTerrain(layout, std::move(bounds)));
  terrain->range = range;
  return terrain;
}
