#include "nodes/seamless/TeSeamlessSceneReader.h"

#include "generators/base/TeText.h"
#include "nodes/TeCoinVectors.h"
#include "nodes/TeSceneFile.h"
#include "nodes/seamless/SoTeSeamlessPatches.h"

#include <cmath>
#include <string>
#include <utility>

namespace {

constexpr int kMostPatches = 1 << 24; ///< more would be an accident: they take gigabytes

glm::vec3 toGlm(const SbColor& colour) { return {colour[0], colour[1], colour[2]}; }

std::string typeName(const SoNode& node) { return node.getTypeId().getName().getString(); }

} // namespace

TeResult<TeSeamlessScene> TeSeamlessSceneReader::read(const TeSeamlessContent& content,
                                                      const glm::dvec3& middle) {
  TeSeamlessScene scene;
  scene.content = content;
  const TeResult<TeSeamlessPlacement> placement = content.place(teToGlm(m_node.size.getValue()), middle);
  if (!placement)
    return placement.error();
  scene.placement = *placement;
  if (TeStatus status = readAccuracy(scene); !status)
    return status.error();
  TeResult<TeSeamlessLook> look = readLook(*content.terrain);
  if (!look)
    return look.error();
  scene.look = std::move(*look);
  const bool partsDiffer = m_node.coloring.getValue() == SoTeSeamlessPatches::PLAIN &&
                           m_node.tileColor.getValue() != m_node.stripColor.getValue();
  scene.wholePatches = m_node.wholePatches.getValue() && !partsDiffer;
  if (TeStatus status = readColours(scene); !status)
    return status.error();
  return scene;
}

TeStatus TeSeamlessSceneReader::readAccuracy(TeSeamlessScene& scene) const {
  TeSeamlessAccuracy& accuracy = scene.accuracy;
  accuracy.precision = double(m_node.precision.getValue());
  accuracy.pixelError = double(m_node.pixelError.getValue());
  accuracy.geomorph = m_node.geomorph.getValue();
  accuracy.maxPatches = m_node.maxPatches.getValue();
  if (!(accuracy.precision >= 1) || !std::isfinite(accuracy.precision))
    return TeError{"precision " + teNumberText(accuracy.precision) +
                   " is not a number from 1; less would leave cracks"};
  if (!(accuracy.pixelError >= 0) || !std::isfinite(accuracy.pixelError))
    return TeError{"pixelError " + teNumberText(accuracy.pixelError) + " is not a number from 0"};
  if (accuracy.maxPatches < 1 || accuracy.maxPatches > kMostPatches)
    return TeError{"maxPatches " + std::to_string(accuracy.maxPatches) + " is not a number from 1 to " +
                   std::to_string(kMostPatches)};
  if (scene.content.isFlat())
    accuracy.pixelError = 0;
  if (accuracy.pixelError > 0 && !scene.content.boundsError.empty())
    return TeError{"pixelError needs the errors of the heights, which terrane-bake measures: " +
                   scene.content.boundsError};
  return {};
}

TeStatus TeSeamlessSceneReader::readColours(TeSeamlessScene& scene) {
  SoNode* node = m_node.colors.getValue();
  if (!node || m_node.coloring.getValue() != SoTeSeamlessPatches::TEXTURE)
    return {};
  if (!node->isOfType(SoTeClipmap::getClassTypeId()))
    return TeError{"colors: a " + typeName(*node) + " is no TeClipmap"};
  scene.colours = static_cast<SoTeClipmap*>(node);
  if (scene.colours->kind.getValue() != SoTeClipmap::COLOR)
    return TeError{"colors: the TeClipmap has heights"};
  scene.colourTiles = scene.colours->getTiles();
  m_isReported = !scene.colourTiles;
  return scene.colourTiles ? TeStatus() : TeStatus(TeError{"colors: " + scene.colours->getError()});
}

TeStatus TeSeamlessSceneReader::readPicture(const char* field, const SbString& file,
                                            std::shared_ptr<const TePicture>& picture) {
  return m_pictures.read(field, teBesideScene(file.getString(), m_folder), picture);
}

TeResult<TeSeamlessLook> TeSeamlessSceneReader::readLook(const TeSeamlessTerrain& terrain) {
  TeSeamlessLook look;
  look.technique.heights = TeSeamlessTechnique::Heights(m_node.heightSource.getValue());
  look.technique.colours = TeSeamlessTechnique::Colours(m_node.coloring.getValue());
  look.technique.instanced = m_node.instancing.getValue();
  look.wireframe = m_node.wireframe.getValue();
  look.geomorph = m_node.geomorph.getValue();
  look.heights = terrain.map;
  look.tileColour = toGlm(m_node.tileColor.getValue());
  look.stripColour = toGlm(m_node.stripColor.getValue());
  TeStatus status;
  switch (m_node.coloring.getValue()) {
  case SoTeSeamlessPatches::TEXTURE:
    if (!m_node.colors.getValue())
      status = readPicture("texture", m_node.texture.getValue(), look.texture);
    break;
  case SoTeSeamlessPatches::DETAIL:
    status = readDetails(look);
    break;
  case SoTeSeamlessPatches::HEIGHT:
    status = readGround(terrain.range, look.slopes);
    break;
  case SoTeSeamlessPatches::PLAIN:
    break;
  default:
    status = TeError{"coloring " + std::to_string(m_node.coloring.getValue()) + " is none of the four"};
  }
  if (!status)
    return status.error();
  return look;
}

TeStatus TeSeamlessSceneReader::readDetails(TeSeamlessLook& look) {
  if (m_node.detailTextures.getNum() != int(look.details.size()))
    return TeError{"detailTextures: four are needed, not " + std::to_string(m_node.detailTextures.getNum())};
  look.detailScale = m_node.detailRepeat.getValue();
  if (!(look.detailScale > 0) || !std::isfinite(look.detailScale))
    return TeError{"detailRepeat " + teNumberText(double(look.detailScale)) + " is not a number above 0"};
  if (TeStatus status = readPicture("mask", m_node.mask.getValue(), look.mask); !status)
    return status;
  for (int i = 0; i < m_node.detailTextures.getNum(); i++) {
    if (TeStatus status =
            readPicture("detailTextures", m_node.detailTextures[i], look.details[std::size_t(i)]);
        !status)
      return status;
  }
  return {};
}

TeStatus TeSeamlessSceneReader::readGround(TeHeightRange range, TeSeamlessSlopeColours& ground) const {
  ground = TeSeamlessSlopeColours::forHeights(range.low, range.high);
  const int layers = int(ground.layers.size());
  if (m_node.groundColors.getNum() > layers)
    return TeError{"groundColors: there are five, not " + std::to_string(m_node.groundColors.getNum())};
  if (m_node.groundHeights.getNum() != 0 && m_node.groundHeights.getNum() != layers - 1)
    return TeError{"groundHeights: four are needed, not " + std::to_string(m_node.groundHeights.getNum())};
  if (m_node.groundSlopes.getNum() != 0 && m_node.groundSlopes.getNum() != layers)
    return TeError{"groundSlopes: five are needed, not " + std::to_string(m_node.groundSlopes.getNum())};
  for (int i = 0; i < m_node.groundColors.getNum(); i++)
    ground.layers[std::size_t(i)].colour = toGlm(m_node.groundColors[i]);
  for (int i = 0; i < m_node.groundHeights.getNum(); i++)
    ground.layers[std::size_t(i) + 1].line = m_node.groundHeights[i];
  for (int i = 0; i < m_node.groundSlopes.getNum(); i++)
    ground.layers[std::size_t(i)].slope = m_node.groundSlopes[i];
  for (const TeSeamlessSlopeColours::Layer& layer : ground.layers) {
    if (!std::isfinite(layer.line + layer.slope + layer.colour.r + layer.colour.g + layer.colour.b))
      return TeError{"groundColors, groundHeights and groundSlopes are finite"};
  }
  return {};
}
