#pragma once

#include "generators/TeGenerator.h"
#include "generators/midpoint/TeMidpointParameters.h"

/// Midpoint displacement (TeMidpointDisplacement) with parameters that may change at any time.
class TeMidpointGenerator final : public TeGenerator, public TeMidpointParameters {
public:
  TeMidpointGenerator() { setDefaults(); }
  std::string name() const override { return "midpoint"; }
  TeParameters parameters() override { return table(); }

protected:
  void setDefaults() override;
  TeResult<TeHeightSourcePtr> makeSource() const override;
};
