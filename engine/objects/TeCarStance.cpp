#include "engine/objects/TeCarStance.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace {

using Geometry = TeCarGeometry;

/// Where a line through `place` along `up` meets the surface: metres along it. Of several points, the first
/// one below a height that is certainly above the ground.
std::optional<double> travelToGround(const TePatchDatabase& terrain, glm::dvec3 place, glm::dvec3 up) {
  constexpr int kDoublings = 24;
  double reach = Geometry::kTravel;
  for (int i = 0; i < kDoublings; ++i, reach *= 2) {
    const glm::dvec3 top = place + reach * up;
    const std::optional<double> ground = terrain.heightAt({top.x, top.y});
    if (!ground)
      return std::nullopt;
    if (top.z <= *ground)
      continue;
    const auto hit = terrain.intersect(top, -up, std::numeric_limits<double>::infinity());
    return hit ? std::optional<double>(reach - hit->distance) : std::nullopt;
  }
  return std::nullopt;
}

/// Turns the axes so that the body lies in the least-squares plane through the ground below its wheels, which
/// stand where the axes were before. False if no wheel has ground.
bool fitPlane(const TePatchDatabase& terrain, glm::dvec2 heading, TeCarStance& stance) {
  std::array<double, Geometry::kWheels> heights{};
  std::array<bool, Geometry::kWheels> known{};
  double sum = 0;
  int count = 0;
  for (int i = 0; i < Geometry::kWheels; ++i) {
    const glm::dvec3 wheel = Geometry::wheel(i);
    const glm::dvec3 offset = stance.right * wheel.x + stance.forward * wheel.y;
    const std::optional<double> height =
        terrain.heightAt({stance.position.x + offset.x, stance.position.y + offset.y});
    known[i] = height.has_value();
    heights[i] = height.value_or(0);
    sum += heights[i];
    count += known[i];
  }
  if (count == 0)
    return false;
  const double mean = sum / count;
  for (int i = 0; i < Geometry::kWheels; ++i)
    if (!known[i])
      heights[i] = mean;

  // The wheels are the corners of a parallelogram, so the plane through the middles of opposite sides is the
  // least-squares plane: it rises by `rise` over `along` and by `bank` over `across`.
  const double rise = 0.5 * (heights[Geometry::FrontLeft] + heights[Geometry::FrontRight] -
                             heights[Geometry::RearLeft] - heights[Geometry::RearRight]);
  const double bank = 0.5 * (heights[Geometry::FrontRight] + heights[Geometry::RearRight] -
                             heights[Geometry::FrontLeft] - heights[Geometry::RearLeft]);
  const glm::dvec2 along = glm::dvec2(stance.forward) * Geometry::kWheelbase;
  const glm::dvec2 across = glm::dvec2(stance.right) * Geometry::kTrack;
  const double area = across.x * along.y - across.y * along.x;
  const glm::dvec2 gradient{(bank * along.y - rise * across.y) / area,
                            (rise * across.x - bank * along.x) / area};
  stance.position.z = mean;
  stance.slope = glm::length(gradient);
  stance.up = glm::normalize(glm::dvec3(-gradient.x, -gradient.y, 1));
  stance.forward = glm::normalize(glm::dvec3(heading, glm::dot(gradient, heading)));
  stance.right = glm::cross(stance.forward, stance.up);
  return true;
}

void makeLevel(glm::dvec2 heading, TeCarStance& stance) {
  stance.right = {heading.y, -heading.x, 0};
  stance.forward = {heading, 0};
  stance.up = {0, 0, 1};
}

glm::dvec3 middleOf(const TeCarStance& stance, int wheel) {
  const glm::dvec3 place = Geometry::wheel(wheel);
  return stance.position + stance.right * place.x + stance.forward * place.y;
}

/// False if a wheel does not reach the ground along a tilted body's up, though there is ground below it.
bool lowerWheels(const TePatchDatabase& terrain, TeCarStance& stance) {
  const bool level = stance.up.z == 1;
  for (int i = 0; i < Geometry::kWheels; ++i) {
    const glm::dvec3 middle = middleOf(stance, i);
    const std::optional<double> ground = terrain.heightAt({middle.x, middle.y});
    std::optional<double> travel;
    if (ground)
      travel = level ? *ground - middle.z : travelToGround(terrain, middle, stance.up);
    if (ground && !travel)
      return false;
    stance.wheels[i].onGround = travel.has_value();
    stance.wheels[i].travel = travel.value_or(-Geometry::kTravel);
  }
  return true;
}

} // namespace

TeCarStance TeCarStance::on(const TePatchDatabase& terrain, glm::dvec2 place, glm::dvec2 heading,
                            double height) {
  TeCarStance stance;
  stance.position = {place, height};
  makeLevel(heading, stance);
  // On a slope the wheels stand closer together, seen from above: once more with the slope known.
  if (!fitPlane(terrain, heading, stance) || !fitPlane(terrain, heading, stance))
    return stance;
  if (stance.slope > Geometry::kSteepest || !lowerWheels(terrain, stance)) {
    makeLevel(heading, stance);
    lowerWheels(terrain, stance);
  }
  return stance;
}

bool TeCarStance::complete() const {
  return std::all_of(wheels.begin(), wheels.end(), [](const Wheel& wheel) { return wheel.onGround; });
}

double TeCarStance::strain() const {
  double strain = slope / Geometry::kSteepest;
  for (const Wheel& wheel : wheels)
    strain = std::max(strain, std::fabs(wheel.travel) / Geometry::kTravel);
  return strain;
}

glm::dquat TeCarStance::orientation() const {
  return glm::normalize(glm::quat_cast(glm::dmat3(right, forward, up)));
}
