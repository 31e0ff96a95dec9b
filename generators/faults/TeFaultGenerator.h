#pragma once

#include "generators/TeGenerator.h"
#include "generators/faults/TeFaultParameters.h"

/// Fault formation (TeFaultFormation) with parameters that may change at any time.
class TeFaultGenerator final : public TeGenerator, public TeFaultParameters {
public:
  TeFaultGenerator() { setDefaults(); }
  std::string name() const override { return "faults"; }
  TeParameters parameters() override { return table(); }

protected:
  void setDefaults() override;
  TeResult<TeHeightSourcePtr> makeSource() const override;
};
