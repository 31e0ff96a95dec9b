#include "nodes/seamless/TeSeamlessShader.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

namespace {

std::vector<TeSeamlessVariant> someVariants() {
  std::vector<TeSeamlessVariant> variants;
  for (int heights = 0; heights < 4; heights++)
    for (int colours = 0; colours < 5; colours++)
      for (int fog = 0; fog < 4; fog++)
        for (int bits = 0; bits < 64; bits++)
          for (const int lights : {0, 1, 2, 3, 4, 0xC000, 0xFFFF}) {
            TeSeamlessVariant variant;
            variant.heights = TeSeamlessVariant::Heights(heights);
            variant.colours = TeSeamlessVariant::Colours(colours);
            variant.fog = TeSeamlessVariant::Fog(fog);
            variant.isLit = bits & 1;
            variant.hasGloss = bits & 2;
            variant.isTwoSided = bits & 4;
            variant.isClipped = bits & 8;
            variant.morphs = bits & 16;
            variant.capturesVertices = bits & 32;
            variant.lights = variant.isLit ? std::uint16_t(lights) : 0;
            variants.push_back(variant);
          }
  return variants;
}

} // namespace

// Else a scene would be drawn by a program that was made for another one.
TEST(TeSeamlessShader, VariantsOfOneKeyHaveOneText) {
  std::map<std::uint32_t, std::string> texts;
  std::map<std::string, std::uint32_t> keys;
  for (const TeSeamlessVariant& variant : someVariants()) {
    // Without the parts that all have in common.
    const std::string whole = TeSeamlessShader::vertex(variant);
    const std::string text = whole.substr(0, whole.find("layout("));
    const auto found = texts.emplace(variant.key(), text).first;
    ASSERT_EQ(found->second, text);
    ASSERT_EQ(keys.emplace(text, variant.key()).first->second, variant.key());
  }
}
