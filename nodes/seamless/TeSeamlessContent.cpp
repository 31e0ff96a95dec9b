#include "nodes/seamless/TeSeamlessContent.h"

#include "generators/elevation/TeElevationOptions.h"
#include "nodes/lod/TeSquareExtent.h"
#include "nodes/seamless/TeSeamlessBoundsFile.h"
#include "nodes/seamless/TeSeamlessHeightFile.h"

#include <utility>

namespace {

constexpr double kLargestNumber = 65535;

TeResult<TeSeamlessLayout> makeLayout(const TeSeamlessContent::Sizes& sizes) {
  return TeSeamlessLayout::create(sizes.resolution, sizes.minPatchResolution, sizes.levels);
}

} // namespace

TeResult<TeSeamlessPlacement> TeSeamlessContent::place(const glm::dvec3& size,
                                                       const glm::dvec3& middle) const {
  const TeResult<TeLodField::Placement> placed =
      TeSquareExtent{terrain->layout.resolution(), spacing, isRaw}.place(size, middle);
  if (!placed)
    return placed.error();
  TeSeamlessPlacement placement;
  placement.corner = placed->corner;
  placement.spacing = placed->spacing;
  placement.heightScale = placed->heightScale;
  placement.range = terrain->range;
  return placement;
}

TeResult<TeSeamlessContent> TeSeamlessContent::flat(const Sizes& sizes) {
  const TeResult<TeSeamlessLayout> layout = makeLayout(sizes);
  if (!layout)
    return layout.error();
  TeSeamlessContent content;
  content.terrain = TeSeamlessTerrain::flat(*layout);
  return content;
}

TeResult<TeSeamlessContent> TeSeamlessContent::ofMap(std::shared_ptr<const TeHeightMap> map,
                                                     const Sizes& sizes) {
  const int cells = map->width() - 1;
  if (map->height() != map->width())
    return TeError{"the height map has " + std::to_string(map->width()) + "x" +
                   std::to_string(map->height()) + " samples, which is no square"};
  if (sizes.resolution != 0 && sizes.resolution != cells)
    return TeError{"resolution " + std::to_string(sizes.resolution) + " needs " +
                   std::to_string(std::int64_t(sizes.resolution) + 1) +
                   " samples a side, but the heights have " + std::to_string(map->width()) +
                   "; 0 takes as many as there are"};
  const TeResult<TeSeamlessLayout> layout = makeLayout({cells, sizes.minPatchResolution, sizes.levels});
  if (!layout)
    return layout.error();
  const TeResult<TeSeamlessTerrainPtr> terrain = TeSeamlessTerrain::create(*layout, std::move(map));
  if (!terrain)
    return terrain.error();
  TeSeamlessContent content;
  content.terrain = *terrain;
  return content;
}

TeResult<TeSeamlessContent> TeSeamlessContent::ofFile(const std::string& path,
                                                      const std::string& verticalUnit, const Sizes& sizes) {
  const TeResult<double> unit = teVerticalUnit(verticalUnit);
  if (!unit)
    return TeError{"verticalUnit: " + unit.error().message};
  TeResult<TeSeamlessHeightFile> file = TeSeamlessHeightFile::read(path, *unit);
  if (!file)
    return file.error();
  TeResult<TeSeamlessContent> content =
      ofMap(std::make_shared<const TeHeightMap>(std::move(file->map)), sizes);
  if (!content)
    return TeError{path + ": " + content.error().message};
  content->isRaw = file->isRaw && *unit == 0;
  if (file->spacing > 0)
    content->spacing = file->spacing;
  return content;
}

TeResult<TeSeamlessContent> TeSeamlessContent::ofClipmap(SoNode* node, const Sizes& sizes, bool& isReported) {
  isReported = false;
  if (!node || !node->isOfType(SoTeClipmap::getClassTypeId()))
    return TeError{"heights: there is no TeClipmap"};
  TeSeamlessContent content;
  content.clipmap = static_cast<SoTeClipmap*>(node);
  if (content.clipmap->kind.getValue() != SoTeClipmap::HEIGHT)
    return TeError{"heights: the TeClipmap has colours"};
  const std::shared_ptr<TePyramidTiles> tiles = content.clipmap->getTiles();
  if (!tiles) {
    isReported = true;
    return TeError{"heights: " + content.clipmap->getError()};
  }
  Sizes known = sizes;
  if (known.resolution == 0)
    known.resolution = 1 << tiles->reader().topLevel();
  const TeResult<TeSeamlessLayout> layout = makeLayout(known);
  if (!layout)
    return layout.error();
  // The first one tells whether there can be any: the base is read, and memory allocated.
  if (const auto windows =
          TeClipWindows::create(tiles, content.clipmap->size.getValue(), layout->resolutionLog());
      !windows)
    return TeError{"heights: " + windows.error().message};
  const std::string file = TeSeamlessBoundsFile::nameFor(content.clipmap->getPath(), *layout);
  const auto bounds = TeSeamlessBoundsFile::load(*layout, file);
  if (!bounds)
    content.boundsError = bounds.error().message;
  content.terrain =
      TeSeamlessTerrain::create(*layout, bounds ? *bounds : nullptr, {0, float(kLargestNumber)});
  content.isRaw = true;
  return content;
}
