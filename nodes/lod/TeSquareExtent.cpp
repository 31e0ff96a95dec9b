#include "nodes/lod/TeSquareExtent.h"

#include "generators/base/TeText.h"

#include <cmath>

namespace {

constexpr double kLargestNumber = 65535;

bool isSize(double metres) { return metres >= 0 && metres <= TeSquareExtent::kLargest; }

} // namespace

TeResult<TeLodField::Placement> TeSquareExtent::place(const glm::dvec3& size,
                                                      const glm::dvec3& middle) const {
  if (!isSize(size.x) || !isSize(size.y) || !isSize(size.z))
    return TeError{"size " + teNumberText(size.x) + " " + teNumberText(size.y) + " " + teNumberText(size.z) +
                   ": extents and height are from 0 to " + teNumberText(kLargest) + " metres"};
  if (size.x != size.y)
    return TeError{"size: the extents in x and y, " + teNumberText(size.x) + " and " + teNumberText(size.y) +
                   ", are not equal"};
  if (!std::isfinite(middle.x) || !std::isfinite(middle.y) || !std::isfinite(middle.z))
    return TeError{"center and origin are not finite"};
  TeLodField::Placement placement;
  placement.spacing = size.x > 0 ? size.x / cells : spacing;
  const double half = placement.spacing * cells / 2;
  placement.corner = middle - glm::dvec3(half, half, 0);
  placement.heightScale = isRaw ? size.z / kLargestNumber : 1;
  return placement;
}
