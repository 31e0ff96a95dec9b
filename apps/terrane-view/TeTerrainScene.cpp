#include "apps/terrane-view/TeTerrainScene.h"

#include "apps/common/TeTerrainDescription.h"
#include "nodes/clipmap/SoTeClipmap.h"
#include "nodes/clipmap/TeClipWindows.h"
#include "nodes/clipmap/TePyramidReader.h"
#include "nodes/lod/SoTeLodTerrain.h"
#include "nodes/seamless/SoTeSeamlessPatches.h"
#include "nodes/seamless/TeSeamlessSlopeColours.h"

#include <Inventor/errors/SoDebugError.h>

#include <algorithm>

namespace {

constexpr int kCoarseLevel = 10;                ///< of a pyramid, to know the ground by: 2 MB
constexpr double kMostSteps = 65535;            ///< of a 16 bit number
constexpr double kDocumentsRelief = 10.0 / 256; ///< height of so many steps, in sides: the document's

/// A level of the pyramid as numbers.
TeResult<std::shared_ptr<const TeHeightMap>> readLevel(const TePyramidReader& files, int level) {
  const int side = (1 << level) + 1;
  TeResult<TeHeightMap> map = TeHeightMap::create(side, side);
  if (!map)
    return map.error();
  std::vector<unsigned char> row(std::size_t(side) * 2);
  for (int y = 0; y < side; ++y) {
    if (const TeStatus ok = files.read(level, {0, y, side, 1}, row.data(), row.size()); !ok)
      return ok.error();
    for (int x = 0; x < side; ++x)
      map->at(x, y) = float(row[std::size_t(2 * x)] | row[std::size_t(2 * x + 1)] << 8);
  }
  return std::make_shared<const TeHeightMap>(std::move(*map));
}

int colouringOf(const TeViewOptions& options) {
  if (options.colouring == "plain")
    return SoTeSeamlessPatches::PLAIN;
  if (options.colouring == "detail")
    return SoTeSeamlessPatches::DETAIL;
  const bool pictures = !options.texture.empty() || !options.colours.empty();
  return pictures && options.colouring != "height" ? SoTeSeamlessPatches::TEXTURE
                                                   : SoTeSeamlessPatches::HEIGHT;
}

/// What the node says of its fields, which Coin need not tell, too.
template <class Node> TeStatus check(Node& node) {
  SoErrorCB* const handler = SoDebugError::getHandlerCallback();
  void* const data = SoDebugError::getHandlerData();
  SoDebugError::setHandlerCallback([](const SoError*, void*) {}, nullptr);
  const std::string error = node.getError();
  SoDebugError::setHandlerCallback(handler, data);
  return error.empty() ? TeStatus() : TeError{error};
}

/// Its fields, all but the heights.
SoTeSeamlessPatches* makeNode(const TeViewOptions& options) {
  auto* node = new SoTeSeamlessPatches;
  node->resolution = 0;
  node->minPatchResolution = options.patchResolution;
  node->levels = options.levels;
  node->coloring = colouringOf(options);
  node->texture = options.texture.c_str();
  node->mask = options.mask.c_str();
  for (std::size_t i = 0; i < options.details.size(); ++i)
    node->detailTextures.set1Value(int(i), options.details[i].c_str());
  if (!options.colours.empty()) {
    auto* colours = new SoTeClipmap;
    colours->name = options.colours.c_str();
    colours->size = options.clipSize;
    colours->kind = SoTeClipmap::COLOR;
    node->colors = colours;
  }
  return node;
}

SoTeLodTerrain* makeLodNode(const TeViewOptions& options) {
  auto* node = new SoTeLodTerrain;
  node->method = options.method.c_str();
  node->coloring = options.colouring == "plain" ? SoTeLodTerrain::PLAIN : SoTeLodTerrain::HEIGHT;
  return node;
}

/// Lines between kinds of ground by the heights that there are, not all that 16 bits could tell.
void setGround(SoTeSeamlessPatches& node, const TeHeightMap& map, double unit, double offset) {
  const TeMapStatistics range = map.statistics();
  const auto metres = [&](float steps) { return float(steps * unit + offset); };
  const TeSeamlessSlopeColours ground =
      TeSeamlessSlopeColours::forHeights(metres(range.minimum), metres(range.maximum));
  for (int i = TeSeamlessSlopeColours::Sand; i <= TeSeamlessSlopeColours::Snow; ++i)
    node.groundHeights.set1Value(i - TeSeamlessSlopeColours::Sand, ground.layers[std::size_t(i)].line);
}

} // namespace

TeResult<TeTerrainScene> TeTerrainScene::fromMap(const TeDemMap& dem, const TeViewOptions& options) {
  TeTerrainScene scene;
  scene.coarse = dem.heights;
  if (options.heightScale > 0) {
    TeHeightMap scaled = *dem.heights;
    if (const TeStatus ok = scaled.scale(float(options.heightScale), scaled.bounds()); !ok)
      return ok.error();
    scene.coarse = std::make_shared<const TeHeightMap>(std::move(scaled));
  }
  const double side = options.side > 0 ? options.side : dem.spacing * dem.cells();
  scene.spacing = side / dem.cells();
  scene.corner = {-0.5 * side, -0.5 * side, 0};
  scene.root = new SoSeparator;
  if (!options.method.empty()) {
    SoTeLodTerrain* node = makeLodNode(options);
    scene.root->addChild(node);
    node->size = SbVec3f(float(side), float(side), 1);
    node->setHeights(scene.coarse);
    if (const TeStatus ok = check(*node); !ok)
      return TeError{options.dem + ": " + ok.error().message};
    return scene;
  }
  SoTeSeamlessPatches* node = makeNode(options);
  scene.root->addChild(node);
  node->size = SbVec3f(float(side), float(side), 1);
  node->heightSource = SoTeSeamlessPatches::HEIGHTMAP;
  node->setHeights(scene.coarse);
  if (const TeStatus ok = check(*node); !ok)
    return TeError{options.dem + ": " + ok.error().message};
  return scene;
}

TeResult<TeTerrainScene> TeTerrainScene::fromPyramid(const TeViewOptions& options) {
  const TeResult<TePyramidReader> files =
      TePyramidReader::open(options.clipmaps, 2, TeClipWindows::wholeLevel(options.clipSize));
  if (!files)
    return files.error();
  TeTerrainDescription scale;
  if (const TeStatus ok = scale.readIfThere(TeTerrainDescription::besidePyramid(options.clipmaps)); !ok)
    return ok.error();
  const int level = std::min(files->topLevel(), std::max(files->baseLevel(), kCoarseLevel));
  const TeResult<std::shared_ptr<const TeHeightMap>> coarse = readLevel(*files, level);
  if (!coarse)
    return coarse.error();

  TeTerrainScene scene;
  scene.coarse = *coarse;
  const double cells = double(1 << files->topLevel());
  const double side = options.side > 0 ? options.side : cells * (scale.spacing > 0 ? scale.spacing : 1);
  const double known = options.heightScale > 0 ? options.heightScale : scale.heightUnit;
  scene.heightScale = known > 0 ? known : kDocumentsRelief * side / kMostSteps;
  scene.spacing = side / double(1 << level);
  scene.corner = {-0.5 * side, -0.5 * side, scale.heightOffset};
  scene.root = new SoSeparator;
  SoTeSeamlessPatches* node = makeNode(options);
  scene.root->addChild(node);
  node->size = SbVec3f(float(side), float(side), float(kMostSteps * scene.heightScale));
  node->center = SbVec3d(0, 0, scale.heightOffset);
  setGround(*node, *scene.coarse, scene.heightScale, scale.heightOffset);
  auto* heights = new SoTeClipmap;
  heights->name = options.clipmaps.c_str();
  heights->size = options.clipSize;
  node->heights = heights;
  node->heightSource = SoTeSeamlessPatches::CLIPMAPS;
  if (const TeStatus ok = check(*node); !ok)
    return TeError{options.clipmaps + ": " + ok.error().message};
  return scene;
}
