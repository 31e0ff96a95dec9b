#include "engine/objects/TeObject.h"

#include "engine/TeStateHash.h"
#include "engine/objects/TeObjects.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <utility>

namespace {

bool finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

bool finite(const glm::dquat& q) {
  return std::isfinite(q.w) && std::isfinite(q.x) && std::isfinite(q.y) && std::isfinite(q.z);
}

} // namespace

TeObject::TeObject(std::string name) : m_name(std::move(name)) {}

TeObject::~TeObject() = default;

TeStatus TeObject::setPosition(const glm::dvec3& position) {
  if (!finite(position))
    return TeError{m_name + ": the position must be finite"};
  m_position = position;
  wake();
  return {};
}

TeStatus TeObject::setVelocity(const glm::dvec3& velocity) {
  if (!finite(velocity))
    return TeError{m_name + ": the velocity must be finite"};
  m_velocity = velocity;
  wake();
  return {};
}

TeStatus TeObject::setOrientation(const glm::dquat& orientation) {
  const double length = glm::length(orientation);
  if (!std::isfinite(length) || !(length > 0))
    return TeError{m_name + ": the orientation must be a finite rotation"};
  m_orientation = orientation / length;
  wake();
  return {};
}

void TeObject::update(const TeUpdate& update) { m_position += m_velocity * update.dt; }

bool TeObject::moving() const { return m_velocity != glm::dvec3(0); }

bool TeObject::handleEvent(const TeKeyEvent&) { return false; }

SoNode* TeObject::drawModel() { return nullptr; }

std::uint64_t TeObject::stateHash() const {
  return teHashState(teHashState(teHashState(teHashText(m_name), m_position), m_velocity), m_orientation);
}

void TeObject::stop() { m_velocity = glm::dvec3(0); }

void TeObject::wake() {
  if (m_awake)
    return;
  m_awake = true;
  if (m_owner)
    m_owner->woken(*this);
}

bool TeObject::isFinite() const { return finite(m_position) && finite(m_velocity) && finite(m_orientation); }
