#include "engine/objects/TeObjects.h"

#include "engine/objects/TeUpdate.h"
#include "generators/base/TeHash.h"
#include "generators/base/TeText.h"
#include "patchdb/TePatchDatabase.h"

#include <algorithm>
#include <cmath>
#include <utility>

TeObjects::TeObjects() = default;

TeObjects::~TeObjects() = default;

TeResult<TeObject*> TeObjects::add(std::unique_ptr<TeObject> object) {
  if (!object)
    return TeError{"TeObjects: no object given"};
  if (!object->isFinite())
    return TeError{object->name() + ": position, velocity and orientation must be finite"};
  TeObject* added = object.get();
  added->m_owner = this;
  added->m_order = m_added++;
  added->m_awake = true;
  m_woken.push_back(added);
  m_all.push_back(std::move(object));
  return added;
}

TeObjects::Owned::const_iterator TeObjects::find(const TeObject* object) const {
  // Only the pointer itself may be looked at: the object may be gone.
  return std::find_if(m_all.begin(), m_all.end(), [&](const auto& one) { return one.get() == object; });
}

bool TeObjects::contains(const TeObject* object) const { return find(object) != m_all.end(); }

bool TeObjects::remove(const TeObject* object) {
  const auto found = find(object);
  if (found == m_all.end())
    return false;
  for (std::vector<TeObject*>* list : {&m_awake, &m_woken, &m_touched}) {
    if (m_updating) // keeps places, for the loop that is running
      std::replace(list->begin(), list->end(), const_cast<TeObject*>(object),
                   static_cast<TeObject*>(nullptr));
    else
      list->erase(std::remove(list->begin(), list->end(), object), list->end());
  }
  const auto owned = m_all.begin() + (found - m_all.cbegin());
  (*owned)->m_owner = nullptr;
  if (m_updating)
    m_removed.push_back(std::move(*owned));
  m_all.erase(owned);
  return true;
}

void TeObjects::admitWoken() {
  if (m_woken.empty())
    return;
  m_woken.erase(std::remove(m_woken.begin(), m_woken.end(), nullptr), m_woken.end());
  const auto before = [](const TeObject* a, const TeObject* b) { return a->m_order < b->m_order; };
  std::sort(m_woken.begin(), m_woken.end(), before);
  const auto middle = std::ptrdiff_t(m_awake.size());
  m_awake.insert(m_awake.end(), m_woken.begin(), m_woken.end());
  std::inplace_merge(m_awake.begin(), m_awake.begin() + middle, m_awake.end(), before);
  if (m_updating)
    m_touched.insert(m_touched.end(), m_woken.begin(), m_woken.end());
  m_woken.clear();
}

const std::vector<TeObject*>& TeObjects::awake() {
  admitWoken();
  return m_awake;
}

TeResult<TeObjects::Tick> TeObjects::update(double dt, const TePatchDatabase& terrain) {
  if (!std::isfinite(dt) || dt < 0)
    return TeError{"TeObjects: a tick of " + teNumberText(dt) + " s: must be 0 or more, and finite"};
  Tick tick;
  tick.simulated = std::min(dt, kLongestTick);
  tick.dropped = dt - tick.simulated;
  admitWoken();
  m_touched = m_awake;
  if (!(dt > 0))
    return tick;

  tick.steps = int(std::ceil(tick.simulated / kLongestStep));
  if (tick.simulated / tick.steps > kLongestStep) // rounding
    ++tick.steps;
  const double length = tick.simulated / tick.steps;
  const double start = m_time;
  m_updating = true;
  for (int i = 1; i <= tick.steps; ++i) {
    m_time = i == tick.steps ? start + tick.simulated : start + length * i;
    admitWoken();
    step({length, m_time, terrain}, tick);
  }
  m_updating = false;
  m_touched.erase(std::remove(m_touched.begin(), m_touched.end(), nullptr), m_touched.end());
  m_removed.clear();
  return tick;
}

void TeObjects::step(const TeUpdate& update, Tick& tick) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < m_awake.size(); ++i) {
    TeObject* object = m_awake[i];
    m_awake[i] = nullptr;
    if (!object)
      continue;
    // In its place while it runs, so that it is found if it removes itself.
    m_awake[kept] = object;
    const bool stays = updateOne(*object, update, tick);
    if (!m_awake[kept])
      continue;
    if (stays)
      ++kept;
    else
      object->m_awake = false;
  }
  m_awake.resize(kept);
  if (!m_removed.empty()) // perhaps one that had had its turn
    m_awake.erase(std::remove(m_awake.begin(), m_awake.end(), nullptr), m_awake.end());
}

bool TeObjects::updateOne(TeObject& object, const TeUpdate& update, Tick& tick) {
  if (object.needsGround() && !update.terrain.heightAt({object.m_position.x, object.m_position.y})) {
    ++tick.held;
    return true;
  }
  const glm::dvec3 position = object.m_position;
  const glm::dquat orientation = object.m_orientation;
  object.update(update);
  ++tick.updates;
  if (object.isFinite())
    return object.moving();
  object.m_position = position;
  object.m_orientation = orientation;
  object.stop();
  object.m_velocity = glm::dvec3(0);
  tick.errors.push_back(
      object.m_name + ": its update at " + teNumberText(update.time) +
      " s left a position, velocity or orientation that is not finite; it was put back and stopped");
  return false;
}

std::uint64_t TeObjects::stateHash() const {
  std::uint64_t hash = m_all.size();
  for (const auto& object : m_all)
    hash = teHashCombine(hash, object->stateHash());
  return hash;
}
