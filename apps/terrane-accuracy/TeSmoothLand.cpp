#include "apps/terrane-accuracy/TeSmoothLand.h"

#include "generators/midpoint/TeMidpointDisplacement.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace {

constexpr int kWaves = 7;
constexpr double kLongest = 512 * TeSmoothLand::kSpacing;
constexpr double kSteepness = 0.06; ///< height of a wave over its length

struct Wave {
  double east, north; ///< radians a metre
  double height;
  double phase;
};

Wave wave(int index) {
  constexpr double kPi = 3.14159265358979323846;
  const double length = kLongest / double(1 << index);
  const double direction = 0.7 + 2.4 * index; // no two along each other
  const double number = 2 * kPi / length;
  return {number * std::cos(direction), number * std::sin(direction), kSteepness * length, 1.3 * index};
}

} // namespace

double TeSmoothLand::height(int column, int row) const {
  double sum = 0;
  for (int i = 0; i < kWaves; ++i) {
    const Wave w = wave(i);
    sum += w.height * std::sin(w.east * kSpacing * column + w.north * kSpacing * row + w.phase);
  }
  return sum;
}

glm::dvec3 TeSmoothLand::normal(int column, int row) const {
  double east = 0, north = 0;
  for (int i = 0; i < kWaves; ++i) {
    const Wave w = wave(i);
    const double slope = w.height * std::cos(w.east * kSpacing * column + w.north * kSpacing * row + w.phase);
    east += w.east * slope;
    north += w.north * slope;
  }
  return glm::normalize(glm::dvec3(-east, -north, 1));
}

TeHeightMap TeSmoothLand::heights(int samples) const {
  TeHeightMap map = TeHeightMap::create(samples, samples).value();
  for (int row = 0; row < samples; ++row)
    for (int column = 0; column < samples; ++column)
      map.at(column, row) = float(height(column, row));
  return map;
}

TeHeightMap teMountains(int samples) {
  TeMidpointParameters parameters;
  parameters.displacement = 600;
  parameters.fall = 0.55;
  const auto source = TeMidpointDisplacement::create(parameters).value();
  return source->generate(TeMapRequest::standalone(samples, samples, TeSmoothLand::kSpacing, 1).value())
      .value();
}
