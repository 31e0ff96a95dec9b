#include "generators/filters/TeMatrixFilter.h"

#include "generators/filters/TeMatrixSource.h"

TeMatrixFilter::TeMatrixFilter() { setDefaults(); }

void TeMatrixFilter::setDefaults() {
  coefficients = "box";
  size = 3;
}

TeParameters TeMatrixFilter::parameters() {
  return {{"coefficients",
           &coefficients,
           0,
           0,
           {},
           "box, gauss, or an odd side squared of numbers, row after row from the south-west"},
          {"size", &size, 1, TeMatrix::kMaxSide, {}, "side of box and gauss, odd"}};
}

TeResult<TeHeightSourcePtr> TeMatrixFilter::makeSource(TeHeightSourcePtr input) const {
  TeResult<TeMatrix> matrix = coefficients == "box"     ? TeMatrix::box(size)
                              : coefficients == "gauss" ? TeMatrix::gauss(size)
                                                        : TeMatrix::parse(coefficients);
  if (!matrix)
    return matrix.error();
  const bool cutAtBorders = !TeMatrixSource::reachesBeyondBorders(*input);
  if (TeStatus ok = matrix->checkSums(cutAtBorders); !ok)
    return ok.error();
  return TeHeightSourcePtr(std::make_shared<TeMatrixSource>(std::move(input), std::move(*matrix)));
}
