#pragma once

#include "generators/TeGenerator.h"
#include "generators/noise/TeNoiseSettings.h"

/// Gradient noise: `noise:type=ridged,octaves=8,wavelength=400,amplitude=120`. The formulas are in
/// TeNoisePlan.h. The maps fit each other as they are.
class TeNoiseGenerator final : public TeGenerator {
public:
  TeNoiseGenerator() { setDefaults(); }

  std::string type; ///< fbm, ridged or warp; goes before settings.type
  TeNoiseSettings settings;

  std::string name() const override { return "noise"; }
  TeParameters parameters() override;

protected:
  void setDefaults() override;
  TeResult<TeHeightSourcePtr> makeSource() const override;
};
