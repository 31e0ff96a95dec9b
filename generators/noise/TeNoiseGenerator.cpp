#include "generators/noise/TeNoiseGenerator.h"

#include "generators/noise/TeNoiseSource.h"

TeParameters TeNoiseGenerator::parameters() {
  TeParameters all = settings.parameters();
  all.insert(all.begin(),
             {"type", &type, 0, 0, {"fbm", "ridged", "warp"}, "hills, mountain crests or folded land"});
  return all;
}

void TeNoiseGenerator::setDefaults() {
  type = "fbm";
  settings = TeNoiseSettings();
}

TeResult<TeHeightSourcePtr> TeNoiseGenerator::makeSource() const {
  TeNoiseSettings chosen = settings;
  chosen.type = type == "ridged" ? TeNoiseType::Ridged
                : type == "warp" ? TeNoiseType::Warp
                                 : TeNoiseType::Fbm;
  return TeNoiseSource::create(chosen);
}
