#pragma once

#include "generators/TeHeightMap.h"
#include "nodes/TePicture.h"
#include "nodes/seamless/TeSeamlessSlopeColours.h"
#include "nodes/seamless/TeSeamlessTechnique.h"

#include <glm/vec3.hpp>

#include <array>
#include <memory>

/// How a terrain of Seamless Patches is to look. Pictures and heights are uploaded when they are first drawn
/// in a context, and again if the pointer becomes another one. All colours are multiplied by that of the
/// scene's material, as the light it reflects.
struct TeSeamlessLook {
  TeSeamlessTechnique technique;
  bool wireframe = false;
  /// Vertices stand between two resolutions as the details' fractions say; without it at their own heights,
  /// and the shader is cheaper.
  bool geomorph = false;

  /// Technique Heightmap: layout.resolution() + 1 samples a side, row 0 in the south, none missing.
  std::shared_ptr<const TeHeightMap> heights;

  glm::vec3 tileColour{1, 1, 1}; ///< technique Color
  glm::vec3 stripColour{1, 0, 0};
  /// Technique Texture: once over the whole terrain, row 0 in the south; not used where the frame has a
  /// colour clipmap.
  std::shared_ptr<const TePicture> texture;
  /// Technique Detailmaps: how much of each detail texture, in red, green, blue and alpha; over the whole
  /// terrain. Shares are divided by their sum.
  std::shared_ptr<const TePicture> mask;
  std::array<std::shared_ptr<const TePicture>, 4> details;
  float detailScale = 64;        ///< times that details are repeated along a side of the terrain; more than 0
  TeSeamlessSlopeColours slopes; ///< technique Slope
};
