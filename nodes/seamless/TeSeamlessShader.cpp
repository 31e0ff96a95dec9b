#include "nodes/seamless/TeSeamlessShader.h"

#include "nodes/seamless/TeSeamlessClipTexture.h"
#include "nodes/seamless/TeSeamlessGlsl.h"

namespace {

std::string macros(const TeSeamlessVariant& variant) {
  std::string text = "#version 330 compatibility\n"
                     "#extension GL_ARB_gpu_shader5 : enable\n"
                     "#ifndef GL_ARB_gpu_shader5\n"
                     "#define precise\n"
                     "#endif\n";
  const auto define = [&](bool condition, const std::string& name) {
    if (condition)
      text += "#define " + name + "\n";
  };
  define(true, "MAX_LEVELS " + std::to_string(TeSeamlessClipTexture::kMaxLevels));
  define(variant.heights == TeSeamlessVariant::Map, "HEIGHT_MAP");
  define(variant.heights >= TeSeamlessVariant::ClipInteger, "HEIGHT_CLIPMAP");
  define(variant.heights == TeSeamlessVariant::ClipInteger, "INTEGER_HEIGHTS");
  define(variant.colours == TeSeamlessVariant::Texture, "ONE_TEXTURE");
  define(variant.colours == TeSeamlessVariant::ColourClipmap, "COLOUR_CLIPMAP");
  define(variant.colours == TeSeamlessVariant::Detailmaps, "DETAIL_MAPS");
  define(variant.colours == TeSeamlessVariant::Slope, "SLOPE_COLOURS");
  define(variant.isLit, "LIT");
  define(variant.hasGloss, "GLOSS");
  define(variant.isTwoSided, "TWO_SIDED");
  define(variant.fog == TeSeamlessVariant::Linear, "FOG(depth) (gl_Fog.end - depth) * gl_Fog.scale");
  define(variant.fog == TeSeamlessVariant::Exp, "FOG(depth) exp(-gl_Fog.density * depth)");
  define(variant.fog == TeSeamlessVariant::Exp2,
         "FOG(depth) exp(-gl_Fog.density * gl_Fog.density * depth * depth)");
  define(variant.isClipped, "CLIPPED");
  define(variant.morphs, "MORPH");
  define(variant.capturesVertices, "CAPTURE");
  define(variant.needsNormal(), "NORMALS");
  std::string lights = "LIGHTS";
  const char* const kinds[] = {"", " DIRECTIONAL", " POINT", " SPOT"};
  for (int i = 0; i < TeSeamlessVariant::kMaxLights; i++)
    if (variant.light(i) != TeSeamlessVariant::None)
      lights += std::string(kinds[variant.light(i)]) + "(" + std::to_string(i) + ")";
  define(variant.isLit, lights);
  return text;
}

} // namespace

std::string TeSeamlessShader::vertex(const TeSeamlessVariant& variant) {
  return macros(variant) + teSeamlessVertexText();
}

std::string TeSeamlessShader::fragment(const TeSeamlessVariant& variant) {
  return macros(variant) + teSeamlessFragmentText();
}
