#include "apps/terrane-accuracy/TeInstancingTerrain.h"

#include "nodes/seamless/TeSeamlessBoundsFile.h"

#include <cassert>
#include <filesystem>

namespace {

float heightOf(const unsigned char* bytes) { return float(bytes[0] + 256 * bytes[1]); }

} // namespace

TeResult<TeInstancingTerrain> TeInstancingTerrain::ofMap(TeMeasuredTerrain map) {
  TeInstancingTerrain terrain;
  terrain.m_name = map.name;
  terrain.m_cells = map.cells();
  terrain.m_spacing = map.spacing();
  terrain.m_heightScale = map.heightScale();
  terrain.m_map = std::make_shared<const TeMeasuredTerrain>(std::move(map));
  return terrain;
}

TeResult<TeInstancingTerrain> TeInstancingTerrain::ofPyramid(const std::string& name, double spacing,
                                                             double heightScale, int clipSize) {
  // The node would warn of what is an error here.
  if (const TeResult<TePyramidReader> reader =
          TePyramidReader::open(name, 2, TeClipWindows::wholeLevel(clipSize));
      !reader)
    return reader.error();
  TeInstancingTerrain terrain;
  terrain.m_name = name;
  terrain.m_clipmap = TeNodePtr<SoTeClipmap>(new SoTeClipmap);
  terrain.m_clipmap->name = name.c_str();
  terrain.m_clipmap->size = clipSize;
  const std::shared_ptr<TePyramidTiles> tiles = terrain.m_clipmap->getTiles();
  if (!tiles)
    return TeError{terrain.m_clipmap->getError()};
  terrain.m_cells = 1 << tiles->reader().topLevel();
  terrain.m_spacing = spacing;
  terrain.m_heightScale = heightScale;
  return terrain;
}

float TeInstancingTerrain::sample(std::int32_t column, std::int32_t row) const {
  if (m_map)
    return m_map->heights().at(column, row);
  const std::shared_ptr<TePyramidTiles> tiles = m_clipmap->getTiles();
  unsigned char bytes[2] = {};
  const TeStatus ok = tiles->read(tiles->reader().topLevel(), {column, row, 1, 1}, bytes, sizeof bytes);
  return ok ? heightOf(bytes) : 0;
}

TeFlyover TeInstancingTerrain::flyover() const {
  TeFlyover flight;
  flight.cells = m_cells;
  flight.spacing = m_spacing;
  flight.heightScale = m_heightScale;
  flight.sample = [this](std::int32_t column, std::int32_t row) { return sample(column, row); };
  return flight;
}

TeResult<std::shared_ptr<const TeSeamlessBounds>>
TeInstancingTerrain::bounds(const TeSeamlessLayout& layout,
                            const TeSeamlessBounds::Progress& progress) const {
  if (m_map)
    return TeSeamlessBounds::create(layout, m_map->heights());
  const std::string file = TeSeamlessBoundsFile::nameFor(m_name, layout);
  if (layout.resolution() == m_cells && std::filesystem::exists(file))
    return TeSeamlessBoundsFile::load(layout, file);
  const std::shared_ptr<TePyramidTiles> tiles = m_clipmap->getTiles();
  const int level = layout.resolutionLog();
  const int side = layout.resolution() + 1;
  std::vector<unsigned char> bytes;
  const auto read = [&](int row, int count, float* samples) -> TeStatus {
    bytes.resize(2 * std::size_t(side) * std::size_t(count));
    if (const TeStatus ok =
            tiles->reader().read(level, {0, row, side, count}, bytes.data(), 2 * std::size_t(side));
        !ok)
      return ok;
    for (std::size_t i = 0; i < bytes.size() / 2; i++)
      samples[i] = heightOf(&bytes[2 * i]);
    return {};
  };
  return TeSeamlessBounds::create(layout, read, progress);
}

TeResult<std::unique_ptr<TeClipWindows>> TeInstancingTerrain::windows(const TeSeamlessLayout& layout) const {
  if (m_map)
    return std::unique_ptr<TeClipWindows>();
  return m_clipmap->makeWindows(layout.resolutionLog());
}

TeNodePtr<SoTeSeamlessPatches> TeInstancingTerrain::node(const TeSeamlessLayout& layout) const {
  TeNodePtr<SoTeSeamlessPatches> node(new SoTeSeamlessPatches);
  const double side = m_spacing * m_cells;
  node->size.setValue(float(side), float(side), float(65535 * m_heightScale));
  node->center.setValue(0.5 * side, 0.5 * side, 0);
  node->resolution = layout.resolution();
  node->minPatchResolution = layout.minResolution();
  node->levels = layout.levels();
  node->stripColor.setValue(1, 1, 1);
  if (m_map) {
    TeHeightMap metres = m_map->heights();
    const TeStatus scaled = metres.scale(float(m_heightScale), metres.bounds());
    assert(scaled);
    static_cast<void>(scaled);
    node->heightSource = SoTeSeamlessPatches::HEIGHTMAP;
    node->setHeights(std::make_shared<const TeHeightMap>(std::move(metres)));
  } else {
    node->heightSource = SoTeSeamlessPatches::CLIPMAPS;
    node->heights = m_clipmap.get();
  }
  return node;
}
