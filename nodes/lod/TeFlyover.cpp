#include "nodes/lod/TeFlyover.h"

#include <algorithm>
#include <cmath>

namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;

} // namespace

TePerspectiveView TeFlyover::view(int frame) const {
  const double angle = anglePerFrame * kDegree * frame;
  const double side = spacing * cells;
  TePerspectiveView view;
  view.eye.x = side * (0.5 + radius * std::cos(angle));
  view.eye.y = side * (0.5 + radius * std::sin(angle));

  const auto first = [&](double metres) {
    return std::max(0, int(std::ceil(metres / spacing)) - kNearCells);
  };
  const auto last = [&](double metres) {
    return std::min(cells, int(std::floor(metres / spacing)) + kNearCells);
  };
  float highest = sample(first(view.eye.x), first(view.eye.y));
  for (int row = first(view.eye.y); row <= last(view.eye.y); row++)
    for (int column = first(view.eye.x); column <= last(view.eye.x); column++)
      highest = std::max(highest, sample(column, row));
  view.eye.z = heightScale * double(highest) + clearance;

  const double level = std::cos(pitch * kDegree);
  view.forward = {-std::sin(angle) * level, std::cos(angle) * level, std::sin(pitch * kDegree)};
  view.width = width;
  view.height = height;
  view.fieldOfView = fieldOfView * kDegree;
  view.nearDistance = nearDistance;
  view.farDistance = farDistance;
  return view;
}
