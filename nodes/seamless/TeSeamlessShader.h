#pragma once

#include "nodes/seamless/TeSeamlessVariant.h"

#include <string>

/// GLSL of Seamless Patches, version 3.30 compatibility: the same text for all variants, after the macros
/// that leave only what a variant needs. Positions: TeSeamlessFrame; morphing: TeSeamlessMesh, bit for bit.
///
/// Lights, material and fog are those of OpenGL's fixed functions, computed for each vertex as these do, with
/// an infinitely distant viewer. Normals come from the height map's texels, or from the neighbours of a
/// vertex, at the distance of the vertices around it, in the clip window of its level.
///
/// Attribute 6 aliases no fixed-function attribute on any known OpenGL.
class TeSeamlessShader {
public:
  static constexpr int kVertexAttribute = 0;   ///< TePartVertex: x, y, chain
  static constexpr int kInstanceAttribute = 6; ///< TeSeamlessInstance
  static constexpr int kHeightsUnit = 0;       ///< texture units
  static constexpr int kColoursUnit = 1;       ///< one texture, the mask, or the colour clipmap
  static constexpr int kFirstDetailUnit = 2;
  static constexpr int kUnits = 6;

  static std::string vertex(const TeSeamlessVariant& variant);
  static std::string fragment(const TeSeamlessVariant& variant);
};
