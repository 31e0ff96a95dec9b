#pragma once

#include <string>

/// The shaders' text after TeSeamlessShader's macros, which say what of it a program has: HEIGHT_MAP,
/// HEIGHT_CLIPMAP, INTEGER_HEIGHTS; ONE_TEXTURE, COLOUR_CLIPMAP, DETAIL_MAPS, SLOPE_COLOURS; LIT, LIGHTS,
/// GLOSS, TWO_SIDED; FOG(depth), CLIPPED, MORPH, NORMALS, CAPTURE; and MAX_LEVELS.
std::string teSeamlessVertexText();
std::string teSeamlessFragmentText();
