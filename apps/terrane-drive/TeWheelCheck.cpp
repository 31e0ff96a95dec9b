#include "apps/terrane-drive/TeWheelCheck.h"

#include <algorithm>
#include <cmath>

void TeWheelCheck::look(const TeCar& car, const TePatchDatabase& terrain) {
  const TeResult<TePatchKey> patch = tePatchAt(terrain.lattice(), car.position());
  if (patch) {
    m_bordersCrossed += m_patch && *m_patch != *patch;
    m_patch = *patch;
  }
  bool allKnown = true;
  for (int wheel = 0; wheel < TeCarGeometry::kWheels; ++wheel) {
    const glm::dvec3 contact = car.wheelContact(wheel);
    const glm::dvec2 below(contact);
    const std::optional<double> ground = terrain.heightAt(below);
    if (!ground || !car.onGround(wheel)) {
      allKnown = false;
      continue;
    }
    m_worstGap = std::max(m_worstGap, std::fabs(contact.z - *ground));
    m_worstTravel = std::max(m_worstTravel, std::fabs(car.travel(wheel)));
    const TeResult<TePatchKey> under = tePatchAt(terrain.lattice(), below);
    m_wheelsOnBorders += under && patch && *under != *patch;
  }
  ++(allKnown ? m_frames : m_framesInTheAir);
}

void TeWheelCheck::describe(nlohmann::ordered_json& report) const {
  report["worst_wheel_gap_m"] = m_worstGap;
  report["frames_wheels_checked"] = m_frames;
  report["frames_wheels_without_ground"] = m_framesInTheAir;
  report["worst_wheel_travel_m"] = m_worstTravel;
  report["borders_crossed"] = m_bordersCrossed;
  report["wheels_across_borders"] = m_wheelsOnBorders;
}
