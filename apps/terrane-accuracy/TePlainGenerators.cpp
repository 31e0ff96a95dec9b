#include "apps/terrane-accuracy/TePlainGenerators.h"

#include <algorithm>
#include <cmath>

namespace {

constexpr double kPi = 3.14159265358979323846;

/// One recursion along `count` samples.
void sweepLine(double* first, std::ptrdiff_t step, int count, double k) {
  for (int i = 1; i < count; ++i)
    first[i * step] = first[(i - 1) * step] * (1 - k) + first[i * step] * k;
}

} // namespace

TeDoubleHeights teInDouble(const TeHeightMap& map) {
  return TeDoubleHeights(map.data(), map.data() + map.bytes() / sizeof(float));
}

TeDoubleHeights tePlainFaults(const TeFaultFormation& source, const TeMapRequest& request) {
  const TeFaultParameters& parameters = source.parameters();
  const int count = source.faults();
  const double fall = count > 1 ? (std::sqrt(parameters.first / parameters.last) - 1) / double(count - 1) : 0;
  TeDoubleHeights heights(std::size_t(request.columns) * std::size_t(request.rows), 0.0);
  const TeRandom random = source.random(request);
  for (int fault = 0; fault < count; ++fault) {
    const double root = 1 + fault * fall;
    const double amount = parameters.first / (root * root);
    const TeFaultLine line = source.line(request, random, fault);
    const double dx = double(line.bx - line.ax), dy = double(line.by - line.ay);
    std::size_t at = 0;
    for (int y = 0; y < request.rows; ++y)
      for (int x = 0; x < request.columns; ++x, ++at) {
        const double side =
            dx * (256.0 * y + 128 - double(line.ay)) - dy * (256.0 * x + 128 - double(line.ax));
        heights[at] += (side > 0 ? amount : 0) - (parameters.centred ? 0.5 * amount : 0);
      }
  }
  return heights;
}

TeDoubleHeights tePlainCircles(const TeCircles& source, const TeMapRequest& request) {
  TeDoubleHeights heights(std::size_t(request.columns) * std::size_t(request.rows), 0.0);
  const TeRandom random = source.random(request);
  for (int index = 0; index < source.parameters().circles; ++index) {
    const TeCircle circle = source.circle(request, random, index);
    const double centreX = double(circle.column) + double(circle.eastward);
    const double centreY = double(circle.row) + double(circle.northward);
    const auto clamped = [](double value, int count) { return int(std::clamp(value, 0.0, double(count))); };
    const int lastX = clamped(centreX + circle.radius + 1, request.columns);
    const int lastY = clamped(centreY + circle.radius + 1, request.rows);
    for (int y = clamped(centreY - circle.radius, request.rows); y < lastY; ++y)
      for (int x = clamped(centreX - circle.radius, request.columns); x < lastX; ++x) {
        const double distance = std::hypot(x - centreX, y - centreY) / circle.radius;
        if (distance < 1)
          heights[std::size_t(y) * std::size_t(request.columns) + std::size_t(x)] +=
              0.5 * double(circle.height) * (1 + std::cos(kPi * distance));
      }
  }
  return heights;
}

TeDoubleHeights tePlainMidpoint(const TeMidpointDisplacement& source, const TeMapRequest& request) {
  const int side = request.columns, last = side - 1;
  TeDoubleHeights heights(std::size_t(side) * std::size_t(side), 0.0);
  const auto height = [&](int x, int y) -> double& {
    return heights[std::size_t(y) * std::size_t(side) + std::size_t(x)];
  };
  const TeRandom random = source.random(request);
  double displacement = source.parameters().displacement;
  const auto displaced = [&](int x, int y, double mean) {
    height(x, y) = mean + displacement * source.displacement(random, std::uint64_t(y) * std::uint64_t(side) +
                                                                         std::uint64_t(x));
  };
  for (const int y : {0, last})
    for (const int x : {0, last})
      displaced(x, y, 0);
  for (int h = last / 2; h > 0; h /= 2, displacement *= source.parameters().fall) {
    for (int y = h; y < side; y += 2 * h)
      for (int x = h; x < side; x += 2 * h)
        displaced(
            x, y,
            (height(x - h, y - h) + height(x + h, y - h) + height(x - h, y + h) + height(x + h, y + h)) / 4);
    for (int y = 0; y < side; y += h)
      for (int x = y / h % 2 == 0 ? h : 0; x < side; x += 2 * h) {
        double sum = 0;
        int known = 0;
        for (const auto& [dx, dy] : {std::pair(-h, 0), {h, 0}, {0, -h}, {0, h}})
          if (x + dx >= 0 && x + dx <= last && y + dy >= 0 && y + dy <= last) {
            sum += height(x + dx, y + dy);
            ++known;
          }
        displaced(x, y, sum / known);
      }
  }
  return heights;
}

void tePlainBand(TeDoubleHeights& heights, int columns, int rows, double k, int passes) {
  double* first = heights.data();
  double* end = first + heights.size() - 1;
  for (int pass = 0; pass < passes; ++pass) {
    for (int y = 0; y < rows; ++y)
      sweepLine(first + y * columns, 1, columns, k);
    for (int y = 0; y < rows; ++y)
      sweepLine(end - y * columns, -1, columns, k);
    for (int x = 0; x < columns; ++x)
      sweepLine(first + x, columns, rows, k);
    for (int x = 0; x < columns; ++x)
      sweepLine(end - x, -columns, rows, k);
  }
}
