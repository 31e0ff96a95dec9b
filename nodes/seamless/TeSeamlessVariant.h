#pragma once

#include <cstdint>
#include <initializer_list>

/// What a program is made for: what the technique and OpenGL's state call for, and nothing else. Classic and
/// instanced drawing share programs.
struct TeSeamlessVariant {
  enum Heights { Flat, Map, ClipInteger, ClipReal };
  enum Colours { Plain, Texture, ColourClipmap, Detailmaps, Slope };
  enum Light { None, Directional, Point, Spot };
  enum Fog { NoFog, Linear, Exp, Exp2 };
  static constexpr int kMaxLights = 8;

  Heights heights = Flat;
  Colours colours = Plain;
  bool isLit = false;
  std::uint16_t lights = 0; ///< two bits a light of OpenGL: Light
  bool hasGloss = false;    ///< the material reflects highlights
  bool isTwoSided = false;
  Fog fog = NoFog;
  bool isClipped = false; ///< by planes of the scene
  bool morphs = false;
  bool capturesVertices = false; ///< transform feedback

  Light light(int number) const { return Light(lights >> (2 * number) & 3); }
  bool needsNormal() const { return isLit || colours == Slope; }
  std::uint32_t key() const {
    std::uint32_t bits = lights;
    for (const int part : {int(heights), int(colours) & 3, int(colours) >> 2, int(fog)})
      bits = bits << 2 | std::uint32_t(part);
    for (const bool part : {isLit, hasGloss, isTwoSided, isClipped, morphs, capturesVertices})
      bits = bits << 1 | std::uint32_t(part);
    return bits;
  }
};
