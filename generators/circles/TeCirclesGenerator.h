#pragma once

#include "generators/TeGenerator.h"
#include "generators/circles/TeCirclesParameters.h"

/// The circles algorithm (TeCircles) with parameters that may change at any time.
class TeCirclesGenerator final : public TeGenerator, public TeCirclesParameters {
public:
  TeCirclesGenerator() { setDefaults(); }
  std::string name() const override { return "circles"; }
  TeParameters parameters() override { return table(); }

protected:
  void setDefaults() override;
  TeResult<TeHeightSourcePtr> makeSource() const override;
};
