#include "generators/circles/TeCirclesGenerator.h"

#include "generators/circles/TeCircles.h"

void TeCirclesGenerator::setDefaults() { static_cast<TeCirclesParameters&>(*this) = TeCirclesParameters(); }

TeResult<TeHeightSourcePtr> TeCirclesGenerator::makeSource() const {
  auto source = TeCircles::create(*this);
  if (!source)
    return source.error();
  return TeHeightSourcePtr(std::move(*source));
}
