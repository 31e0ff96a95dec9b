#pragma once

#include "generators/TeFilter.h"

/// Matrix filter: each sample becomes the weighted mean of its neighbourhood (document 002; TeMatrix has the
/// convention). In double, summed row by row from the south-west, rounded to float once; so a flat map stays
/// as it is.
///
/// Missing samples stay missing, and count as not at hand for their neighbours; where the coefficients at
/// hand cancel out because of them, the result is missing. At a map's borders the samples at hand are used,
/// unless the input fits and can be evaluated at scattered points: the filter then takes the samples beyond
/// the border as well, and its result fits too. Over an input that can be evaluated at scattered points the
/// result can be, with the same bits.
class TeMatrixFilter final : public TeFilter {
public:
  TeMatrixFilter();
  std::string name() const override { return "matrix"; }
  TeParameters parameters() override;

  /// `box`, `gauss`, or the numbers themselves, row after row from the south.
  std::string coefficients;
  int size; ///< side of `box` and `gauss`, odd

protected:
  void setDefaults() override;
  TeResult<TeHeightSourcePtr> makeSource(TeHeightSourcePtr input) const override;
};
