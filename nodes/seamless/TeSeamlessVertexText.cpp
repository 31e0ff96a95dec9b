#include "nodes/seamless/TeSeamlessGlsl.h"

namespace {

constexpr const char* kVertexInput = R"(
layout(location = 0) in uvec3 vertexPlace; // x, y of the part's patch; chain
layout(location = 6) in ivec4 patchInstance; // south-west sample; log2 of its cells; weights

uniform ivec2 eyeSample;
uniform vec2 eyeFraction;
uniform float spacing;
uniform vec2 heightToZ; // scale, z of height 0
uniform mat4 clipFromRelative;
uniform mat3 viewFromRelative;
uniform mat3 viewFromNormal;
uniform int patchLog;   // of the highest resolution of a patch
uniform ivec4 sideStepLog; // log2 of the distance of vertices by side
uniform float terrainFromSample;

// A chain of vertices has that of its side, or on a diagonal the shorter one of two sides.
int stepLogOf(int chain) {
  return chain < 4 ? sideStepLog[chain] : min(sideStepLog[chain - 4], sideStepLog[(chain - 3) & 3]);
}

ivec2 sampleAt(ivec2 place) {
  int finer = patchInstance.z - patchLog;
  return patchInstance.xy + ((place << max(finer, 0)) >> max(-finer, 0));
}
)";

constexpr const char* kHeights = R"(
#if defined(HEIGHT_MAP)
uniform usampler2D heights; // height; slopes to the east and north, 16 bits each
float heightAt(ivec2 place) {
  return uintBitsToFloat(texelFetch(heights, sampleAt(place), 0).r);
}
#elif defined(HEIGHT_CLIPMAP)
#ifdef INTEGER_HEIGHTS
uniform usampler2DArray heights;
#else
uniform sampler2DArray heights;
uniform float heightUnit;
#endif
uniform ivec4 clipWindows[2 * MAX_LEVELS]; // x, y, and both modulo the clip size; side
uniform ivec4 clip;                        // size, base level, highest layer, log2 of the finest level
int clipLayer;
int clipShift;

// A sample of the layer's level, in its window: no division is needed for the modulo.
float texelAt(ivec2 place) {
  ivec4 window = clipWindows[2 * clipLayer];
  ivec2 texel = place - window.xy + window.zw;
  texel -= clip.x * ivec2(greaterThanEqual(texel, ivec2(clip.x)));
#ifdef INTEGER_HEIGHTS
  return float(texelFetch(heights, ivec3(texel, clipLayer), 0).r);
#else
  precise float height = texelFetch(heights, ivec3(texel, clipLayer), 0).r * heightUnit;
  return height;
#endif
}
float heightAt(ivec2 place) { return texelAt(sampleAt(place) >> clipShift); }
#endif

#if defined(MORPH) && (defined(HEIGHT_MAP) || defined(HEIGHT_CLIPMAP))
int sideWeight(int side) { return (patchInstance.w >> (8 * side)) & 255; }

float morphed(float own, ivec2 place, int chain) {
  int first = chain & 3;
  int weight = sideWeight(first);
  if (chain >= 4) {
    int second = (first + 1) & 3;
    if (sideStepLog[first] > sideStepLog[second])
      weight = sideWeight(second);
    else if (sideStepLog[first] == sideStepLog[second])
      weight = max(weight, sideWeight(second));
  }
  ivec2 odd = place & (1 << stepLogOf(chain));
  if (weight == 255 || odd == ivec2(0))
    return own;
  int middle = 1 << (patchLog - 1);
  if ((place.x < middle) != (place.y < middle))
    odd.y = -odd.y; // cells' diagonals point to the centre of the patch
  precise float between = 0.5 * (heightAt(place - odd) + heightAt(place + odd));
  precise float height = between + float(weight) * (1.0 / 255.0) * (own - between);
  return height;
}
#endif
)";

constexpr const char* kLighting = R"(
#ifdef LIT
uniform vec4 material;

struct Light {
  vec3 ambient;
  vec3 diffuse;
  vec3 specular;
};

float highlight(vec3 normal, vec3 halfway) {
  return pow(max(dot(normal, halfway), 1e-8), gl_FrontMaterial.shininess);
}

void add(inout Light sum, int i, vec3 normal, vec3 toLight, float share) {
  sum.ambient += share * gl_FrontLightProduct[i].ambient.rgb;
  float cosine = dot(normal, toLight);
  sum.diffuse += share * max(cosine, 0.0) * gl_LightSource[i].diffuse.rgb;
#ifdef GLOSS
  if (cosine > 0.0)
    sum.specular += share * highlight(normal, normalize(toLight + vec3(0, 0, 1))) *
                    gl_FrontLightProduct[i].specular.rgb;
#endif
}

float attenuation(int i, float away) {
  return 1.0 / (gl_LightSource[i].constantAttenuation + away * (gl_LightSource[i].linearAttenuation +
                away * gl_LightSource[i].quadraticAttenuation));
}

float spot(int i, vec3 toLight) {
  float cosine = dot(-toLight, normalize(gl_LightSource[i].spotDirection));
  return cosine < gl_LightSource[i].spotCosCutoff ? 0.0 : pow(max(cosine, 1e-8), gl_LightSource[i].spotExponent);
}

void addPoint(inout Light sum, int i, vec3 normal, vec3 position) {
  vec3 toLight = gl_LightSource[i].position.xyz / gl_LightSource[i].position.w - position;
  float away = length(toLight);
  add(sum, i, normal, toLight / away, attenuation(i, away));
}

void addSpot(inout Light sum, int i, vec3 normal, vec3 position) {
  vec3 toLight = gl_LightSource[i].position.xyz / gl_LightSource[i].position.w - position;
  float away = length(toLight);
  toLight /= away;
  add(sum, i, normal, toLight, spot(i, toLight) * attenuation(i, away));
}

#define DIRECTIONAL(i) add(sum, i, normal, normalize(gl_LightSource[i].position.xyz), 1.0);
#define POINT(i) addPoint(sum, i, normal, position);
#define SPOT(i) addSpot(sum, i, normal, position);

vec3 lit(vec3 normal, vec3 position) {
  Light sum = Light(gl_FrontLightModelProduct.sceneColor.rgb, vec3(0), vec3(0));
  LIGHTS
  return min(sum.ambient + sum.diffuse * material.rgb + sum.specular, vec3(1));
}
#endif
)";

constexpr const char* kVertexMain = R"(
#ifdef LIT
centroid out vec3 frontColour; // not extrapolated where a pixel is partly covered
#ifdef TWO_SIDED
centroid out vec3 backColour;
#endif
#endif
#if defined(ONE_TEXTURE) || defined(COLOUR_CLIPMAP) || defined(DETAIL_MAPS)
out vec2 terrainPlace;
#endif
#ifdef SLOPE_COLOURS
centroid out vec2 ground; // height, slope
#endif
#ifdef FOG
out float fogDepth;
#endif
#ifdef CAPTURE
out vec3 drawnPosition;
flat out ivec2 drawnSample;
out float drawnHeight;
#endif
#ifdef NORMALS
uniform float slopeScale; // metres a metre for a unit of height a sample
#ifdef HEIGHT_MAP
uniform float slopeUnit;
#endif
#endif

void main() {
  ivec2 place = ivec2(vertexPlace.xy);
  int chain = int(vertexPlace.z);
  ivec2 own = sampleAt(place);
  float height = 0.0;
#if defined(HEIGHT_MAP)
  uvec2 texel = texelFetch(heights, own, 0).rg;
  height = uintBitsToFloat(texel.r);
#elif defined(HEIGHT_CLIPMAP)
  int spacingLog = stepLogOf(chain) + patchInstance.z - patchLog;
  clipLayer = clamp(clip.w - spacingLog - clip.y, 0, clip.z);
  clipShift = clip.w - clip.y - clipLayer;
  ivec2 texel = own >> clipShift;
  height = texelAt(texel);
#endif
#if defined(MORPH) && (defined(HEIGHT_MAP) || defined(HEIGHT_CLIPMAP))
  height = morphed(height, place, chain);
#endif
  precise vec3 relative = vec3(vec2(own - eyeSample) * spacing - eyeFraction, height * heightToZ.x + heightToZ.y);
  gl_Position = clipFromRelative * vec4(relative, 1);

#if defined(LIT) || defined(FOG) || defined(CLIPPED)
  vec3 position = viewFromRelative * relative;
#endif
#ifdef NORMALS
  vec2 slope = vec2(0); // units of height a sample
#if defined(HEIGHT_MAP)
  slope = vec2(ivec2(texel.g << 16, texel.g) >> 16) * slopeUnit;
#elif defined(HEIGHT_CLIPMAP)
  int reach = max((1 << spacingLog) >> clipShift, 1);
  ivec2 low = clipWindows[2 * clipLayer].xy;
  ivec2 high = low + clipWindows[2 * clipLayer + 1].x - 1;
  ivec2 before = max(texel - reach, low);
  ivec2 after = min(texel + reach, high);
  slope = vec2(texelAt(ivec2(after.x, texel.y)) - texelAt(ivec2(before.x, texel.y)),
               texelAt(ivec2(texel.x, after.y)) - texelAt(ivec2(texel.x, before.y))) /
          vec2(max(after - before, ivec2(1)) << clipShift);
#endif
  slope *= slopeScale;
#endif
#ifdef LIT
  vec3 normal = normalize(viewFromNormal * vec3(-slope, 1));
  frontColour = lit(normal, position);
#ifdef TWO_SIDED
  backColour = lit(-normal, position);
#endif
#endif
#if defined(ONE_TEXTURE) || defined(COLOUR_CLIPMAP) || defined(DETAIL_MAPS)
  terrainPlace = vec2(own) * terrainFromSample;
#endif
#ifdef SLOPE_COLOURS
  ground = vec2(height * heightToZ.x, length(slope));
#endif
#ifdef FOG
  fogDepth = abs(position.z);
#endif
#ifdef CLIPPED
  gl_ClipVertex = vec4(position, 1);
#endif
#ifdef CAPTURE
  drawnPosition = relative;
  drawnSample = own;
  drawnHeight = height;
#endif
}
)";

} // namespace

std::string teSeamlessVertexText() { return std::string(kVertexInput) + kHeights + kLighting + kVertexMain; }
