#include "nodes/seamless/TeSeamlessLookReader.h"

#include "generators/base/TeText.h"
#include "nodes/TeSceneFile.h"
#include "nodes/seamless/SoTeSeamlessPatches.h"

#include <cmath>

namespace {

glm::vec3 toGlm(const SbColor& colour) { return {colour[0], colour[1], colour[2]}; }

} // namespace

TeStatus TeSeamlessLookReader::readPicture(const char* field, const SbString& file,
                                           std::shared_ptr<const TePicture>& picture) {
  return m_pictures.read(field, teBesideScene(file.getString(), m_folder), picture);
}

TeResult<TeSeamlessLook> TeSeamlessLookReader::read(const TeSeamlessTerrain& terrain) {
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
  }
  if (!status)
    return status.error();
  return look;
}

TeStatus TeSeamlessLookReader::readDetails(TeSeamlessLook& look) {
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

TeStatus TeSeamlessLookReader::readGround(TeHeightRange range, TeSeamlessSlopeColours& ground) const {
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
