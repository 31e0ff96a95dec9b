#include "engine/paths/TePathAircraft.h"

#include "generators/base/TeHash.h"
#include "patchdb/TePatchDatabase.h"

TePathAircraft::TePathAircraft(std::string name, TePathTraveller traveller, const SbColor& colour)
    : TeAircraft(std::move(name), colour), m_traveller(std::move(traveller)) {}

void TePathAircraft::update(const TeUpdate& update) {
  const std::int64_t jumps = m_traveller.jumps();
  m_traveller.advance(update.dt);
  const bool jumped = m_traveller.jumps() != jumps;
  glm::dvec3 target = m_traveller.place();
  target.z = altitude(update, jumped);
  // The base class moves it by this velocity, banks it and keeps it clear of the ground.
  move(jumped ? m_traveller.direction() * m_traveller.speed() : (target - position()) / update.dt);
  if (jumped)
    place(target - velocity() * update.dt);
  TeAircraft::update(update);
  if (m_traveller.ended())
    stop();
}

double TePathAircraft::altitude(const TeUpdate& update, bool jumped) {
  const glm::dvec3 place = m_traveller.place();
  if (!m_traveller.aboveGround())
    return place.z;
  const std::optional<double> ground = update.terrain.heightAt({place.x, place.y});
  if (ground)
    m_ground = *ground;
  const double wanted = m_ground + place.z;
  if (jumped) {
    m_climb = 0;
    return wanted;
  }
  const double offset = ground ? wanted - position().z : 0;
  m_climb += (kStiffness * kStiffness * offset - 2 * kStiffness * m_climb) * update.dt;
  return position().z + m_climb * update.dt;
}

bool TePathAircraft::handleEvent(const TeKeyEvent&) { return false; }

std::vector<std::string> TePathAircraft::helpLines() const { return {"(flies a path by itself)"}; }

std::uint64_t TePathAircraft::stateHash() const {
  std::uint64_t hash = TeAircraft::stateHash();
  for (const double value : {m_traveller.distance(), m_ground, m_climb})
    hash = teHashDouble(hash, value);
  return teHashCombine(hash, std::uint64_t(m_traveller.jumps()));
}
