#include "nodes/seamless/TeSeamlessGlsl.h"

namespace {

constexpr const char* kFragment = R"(
uniform vec4 material;
#ifdef LIT
centroid in vec3 frontColour;
#ifdef TWO_SIDED
centroid in vec3 backColour;
#endif
#endif
#if defined(ONE_TEXTURE) || defined(COLOUR_CLIPMAP) || defined(DETAIL_MAPS)
in vec2 terrainPlace;
#endif
#ifdef FOG
in float fogDepth;
#endif

#if defined(ONE_TEXTURE)
uniform sampler2D colours;
vec3 surface() { return texture(colours, terrainPlace).rgb; }

#elif defined(DETAIL_MAPS)
uniform sampler2D colours;
uniform sampler2D detail0;
uniform sampler2D detail1;
uniform sampler2D detail2;
uniform sampler2D detail3;
uniform float detailScale;
vec3 surface() {
  vec4 share = texture(colours, terrainPlace);
  share /= max(dot(share, vec4(1)), 1e-3);
  vec2 place = terrainPlace * detailScale;
  return share.r * texture(detail0, place).rgb + share.g * texture(detail1, place).rgb +
         share.b * texture(detail2, place).rgb + share.a * texture(detail3, place).rgb;
}

#elif defined(COLOUR_CLIPMAP)
uniform sampler2DArray colours;
uniform ivec4 colourWindows[MAX_LEVELS]; // x, y, side
uniform ivec4 colourClip;                // size, base level, highest layer, log2 of the finest level
// The level with samples as far apart as pixels, or the finest below it that is here.
vec3 surface() {
  vec2 finest = terrainPlace * float(1 << colourClip.w);
  float footprint = max(length(dFdx(finest)), length(dFdy(finest)));
  int layer = int(floor(float(colourClip.w) + 0.5 - log2(max(footprint, 1.0)))) - colourClip.y;
  layer = clamp(layer, 0, colourClip.z);
  vec2 texel = vec2(0);
  for (; layer >= 0; layer--) {
    texel = terrainPlace * float(1 << (layer + colourClip.y));
    vec2 low = vec2(colourWindows[layer].xy);
    vec2 high = low + float(colourWindows[layer].z - 1);
    if (layer == 0 || (all(greaterThanEqual(texel, low)) && all(lessThanEqual(texel, high)))) {
      texel = clamp(texel, low, high);
      break;
    }
  }
  return textureLod(colours, vec3((texel + 0.5) / float(colourClip.x), float(layer)), 0.0).rgb;
}

#elif defined(SLOPE_COLOURS)
centroid in vec2 ground;
uniform vec4 groundLayers[10]; // colour and line; slope
uniform vec2 groundBlend;
float above(float line, float blend, float value) {
  return smoothstep(line - 0.5 * blend, line + 0.5 * blend, value);
}
vec3 surface() {
  vec3 colour = vec3(0);
  for (int i = 0; i < 5; i++) {
    float steep = above(groundLayers[2 * i + 1].x, groundBlend.y, ground.y);
    vec3 layer = mix(groundLayers[2 * i].rgb, groundLayers[6].rgb, steep);
    colour = i == 0 ? layer : mix(colour, layer, above(groundLayers[2 * i].a, groundBlend.x, ground.x));
  }
  return colour;
}
#else
vec3 surface() { return vec3(1); }
#endif

void main() {
#if !defined(LIT)
  vec3 colour = material.rgb;
#elif defined(TWO_SIDED)
  vec3 colour = gl_FrontFacing ? frontColour : backColour;
#else
  vec3 colour = frontColour;
#endif
  colour *= surface();
#ifdef FOG
  colour = mix(gl_Fog.color.rgb, colour, clamp(FOG(fogDepth), 0.0, 1.0));
#endif
  gl_FragColor = vec4(colour, material.a);
}
)";

} // namespace

std::string teSeamlessFragmentText() { return kFragment; }
