#include "generators/midpoint/TeMidpointGenerator.h"

#include "generators/midpoint/TeMidpointDisplacement.h"

void TeMidpointGenerator::setDefaults() {
  static_cast<TeMidpointParameters&>(*this) = TeMidpointParameters();
}

TeResult<TeHeightSourcePtr> TeMidpointGenerator::makeSource() const {
  auto source = TeMidpointDisplacement::create(*this);
  if (!source)
    return source.error();
  return TeHeightSourcePtr(std::move(*source));
}
