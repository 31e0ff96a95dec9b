#include "generators/faults/TeFaultGenerator.h"

#include "generators/faults/TeFaultFormation.h"

void TeFaultGenerator::setDefaults() { static_cast<TeFaultParameters&>(*this) = TeFaultParameters(); }

TeResult<TeHeightSourcePtr> TeFaultGenerator::makeSource() const {
  auto source = TeFaultFormation::create(*this);
  if (!source)
    return source.error();
  return TeHeightSourcePtr(std::move(*source));
}
