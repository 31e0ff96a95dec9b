#include "generators/noise/TeNoiseGenerator.h"

#include "generators/TeGeneratorRegistry.h"
#include "generators/noise/TeNoiseSource.h"

#include <gtest/gtest.h>

#include <string>

TEST(TeNoiseGenerator, MakesTheSourceOfItsSpecification) {
  const TeMapRequest request = *TeMapRequest::standalone(20, 30, 1.0, 1);
  const auto source = TeGeneratorRegistry::instance().source("noise:type=warp,octaves=3,warp=0.1,seed=5");
  ASSERT_TRUE(source.ok()) << source.error().message;
  TeNoiseSettings settings;
  settings.type = TeNoiseType::Warp;
  settings.octaves = 3;
  settings.warp = 0.1;
  settings.seed = 5;
  EXPECT_EQ(*(*source)->generate(request), *(*TeNoiseSource::create(settings))->generate(request));
}

TEST(TeNoiseGenerator, UnusableSettingsAreErrorsThatNameTheParameter) {
  const TeGeneratorRegistry& registry = TeGeneratorRegistry::instance();
  for (const char* specification :
       {"noise:octaves=0", "noise:octaves=17", "noise:wavelength=0", "noise:wavelength=nan",
        "noise:amplitude=inf", "noise:lacunarity=0.5", "noise:gain=2", "noise:type=white", "noise:warp=-1",
        "noise:warp-octaves=0"}) {
    const auto source = registry.source(specification);
    ASSERT_FALSE(source.ok()) << specification;
    const std::string text = specification;
    const std::string parameter = text.substr(6, text.find('=') - 6);
    EXPECT_NE(source.error().message.find(parameter), std::string::npos) << source.error().message;
  }
}

TEST(TeNoiseGenerator, ChangesDuringAJobTakeEffectWithTheNext) {
  const TeMapRequest request = *TeMapRequest::standalone(65, 65, 1.0, 1);
  TeNoiseGenerator generator;
  ASSERT_TRUE(generator.start(request).ok());
  generator.type = "ridged";
  ASSERT_TRUE(generator.generate().ok());
  const TeHeightMap before = generator.takeMap();
  EXPECT_EQ(before, *(*TeNoiseSource::create(TeNoiseSettings()))->generate(request));
  ASSERT_TRUE(generator.start(request).ok());
  ASSERT_TRUE(generator.generate().ok());
  EXPECT_NE(generator.takeMap(), before);
}
