#pragma once

#include <cstdint>

/// What the texels of a clipmap's texture are.
enum class TeClipFormat {
  Short,  ///< GL_R16UI: the heights themselves, exact; needs usampler2DArray
  Half,   ///< GL_R16F: height / 65535, rounded to the nearest half; off by up to 16 of 65535 steps
  Float,  ///< GL_R32F: the heights themselves, exact
  Colour, ///< GL_RGBA8; alpha is 1 where a sample has three bytes
};

int teTexelBytes(TeClipFormat format);
/// What a shader multiplies a texel with to get the height: 65535 for Half, else 1.
float teTexelScale(TeClipFormat format);
/// The height that a shader gets for a sample, to the bit; not for Colour.
float teDrawnHeight(std::uint16_t sample, TeClipFormat format);
/// By how much that may differ from the sample: 16 for Half, else 0.
float teDrawnRounding(TeClipFormat format);
/// The bits of the half nearest to sample / 65535; of two equally near, the even one.
std::uint16_t teHalfOfSample(std::uint16_t sample);
float teFloatOfHalf(std::uint16_t half);
