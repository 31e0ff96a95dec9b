#include "generators/faults/TeFaultPlane.h"

#include <cmath>

namespace {

constexpr std::int64_t kHalfSample = 128;

std::int64_t rounded(double value) { return std::int64_t(std::floor(value + 0.5)); }

} // namespace

TeFaultPlane TeFaultPlane::step(const TeFaultLine& line, std::int64_t amplitude) {
  const std::int64_t dx = line.bx - line.ax;
  const std::int64_t dy = line.by - line.ay;
  TeFaultPlane plane;
  plane.origin = dx * (kHalfSample - line.ay) - dy * (kHalfSample - line.ax);
  plane.east = -256 * dy;
  plane.north = 256 * dx;
  plane.weight = amplitude;
  if (plane.east < 0) {
    // [v > 0] = 1 - [1 - v > 0]
    plane.origin = 1 - plane.origin;
    plane.east = -plane.east;
    plane.north = -plane.north;
    plane.weight = -amplitude;
    plane.base = amplitude;
  }
  return plane;
}

TeFaultPlane TeFaultPlane::smooth(const TeFaultLine& line, std::int64_t amplitude, double width) {
  const double dx = double(line.bx - line.ax);
  const double dy = double(line.by - line.ay);
  const double scale = 2.0 * double(kRampHalf) / (width * std::sqrt(dx * dx + dy * dy));
  TeFaultPlane plane;
  plane.east = rounded(-scale * dy);
  plane.north = rounded(scale * dx);
  if (plane.east == 0)
    plane.east = 1;
  plane.origin =
      kRampHalf - ((plane.east * (line.ax - kHalfSample) + plane.north * (line.ay - kHalfSample)) >> 8);
  plane.weight = amplitude;
  if (plane.east < 0) {
    // The ramp is symmetric: p(v) = full - p(2H - v).
    plane.origin = 2 * kRampHalf - plane.origin;
    plane.east = -plane.east;
    plane.north = -plane.north;
    plane.weight = -amplitude;
    plane.base = amplitude;
  }
  return plane;
}
