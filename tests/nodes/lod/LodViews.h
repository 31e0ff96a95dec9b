#pragma once

#include "generators/TeHeightMap.h"
#include "nodes/lod/TeLodView.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

/// Sees everything from a point.
inline TeLodView viewFrom(const glm::dvec3& eye, double focal = 665.1) {
  TeLodView view;
  view.eye = eye;
  view.focal = focal;
  return view;
}

/// Cuts the view of a camera that looks along `direction` by planes through the eye.
inline void lookAlong(TeLodView& view, const glm::dvec3& direction, double halfAngle) {
  const glm::dvec3 forward = glm::normalize(direction);
  const glm::dvec3 helper = std::abs(forward.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, helper));
  const glm::dvec3 up = glm::cross(right, forward);
  view.planeCount = 0;
  for (const glm::dvec3& across : {right, -right, up, -up}) {
    const glm::dvec3 normal = std::sin(halfAngle) * forward + std::cos(halfAngle) * across;
    view.planes[std::size_t(view.planeCount++)] = glm::dvec4(normal, -glm::dot(normal, view.eye));
  }
}

/// Any eye a demo or an adversary may choose: over the square and far outside, high, low and below, on
/// corners and edges of patches, and the numbers next to them.
template <class Random> glm::dvec3 anyEye(Random& random, double side, double relief) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  glm::dvec3 eye(uniform(-0.3, 1.3) * side, uniform(-0.3, 1.3) * side, uniform(-0.2, 2) * relief);
  if (random() % 3 == 0)
    eye.z = relief * std::exp(uniform(-5, 5));
  if (random() % 2 == 0) {
    // On the lattice of patches.
    const double step = side / double(1 << random() % 8);
    for (int axis = 0; axis < 2; axis++)
      if (random() % 4 != 0)
        eye[axis] = std::round(eye[axis] / step) * step;
    if (random() % 3 == 0)
      eye.z = 0;
    for (int axis = 0; axis < 3; axis++)
      if (random() % 4 == 0)
        eye[axis] = std::nextafter(eye[axis], random() % 2 ? 1e30 : -1e30);
  }
  return eye;
}

/// Maps that have broken LOD methods.
enum class StressField { Rough, Spike, Cliff, Plateau, Checkerboard, Flat };

template <class Random> TeHeightMap stressMap(StressField field, int resolution, Random& random) {
  TeHeightMap map = TeHeightMap::create(resolution + 1, resolution + 1).value();
  const int spikeX = int(random() % std::uint32_t(resolution + 1));
  const int spikeY = int(random() % std::uint32_t(resolution + 1));
  for (int y = 0; y <= resolution; y++)
    for (int x = 0; x <= resolution; x++) {
      float height = 0;
      switch (field) {
      case StressField::Rough:
        height = float(20 * std::sin(x * 0.13) * std::cos(y * 0.11) + double(random() % 1000) * 0.01);
        break;
      case StressField::Spike:
        height = x == spikeX && y == spikeY ? 100.0f : 0.0f;
        break;
      case StressField::Cliff:
        height = x > spikeX ? 10000.0f : 0.0f;
        break;
      case StressField::Plateau:
        height =
            std::abs(x - resolution / 2) < spikeX && std::abs(y - resolution / 2) < spikeY ? 50.0f : 0.0f;
        break;
      case StressField::Checkerboard:
        height = (x + y) % 2 ? 5.0f : 0.0f;
        break;
      case StressField::Flat:
        height = 7;
        break;
      }
      map.at(x, y) = height;
    }
  return map;
}
