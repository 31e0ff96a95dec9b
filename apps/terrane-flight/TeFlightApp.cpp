#include "apps/terrane-flight/TeFlightApp.h"

#include "engine/TeEngine.h"
#include "engine/paths/TeNamedPaths.h"
#include "engine/paths/TePathAircraft.h"
#include "generators/base/TeText.h"

#include <algorithm>
#include <filesystem>

namespace {

constexpr double kCompanionX = -60; ///< metres from the user
/// The first altitude, of what is seen ahead: the rim of the block is 7° below or little more.
constexpr double kAltitudeShare = 0.12;
constexpr double kHighestStart = 1000; ///< metres above the ground
const SbColor kCompanionColour(0.15f, 0.35f, 0.75f);

bool isPathName(const std::string& path) {
  const std::vector<std::string>& names = tePathNames();
  return std::find(names.begin(), names.end(), path) != names.end();
}

/// A path that leads out of the world could not have ground everywhere.
TeStatus checkInWorld(const TePath& path, const TeLattice& lattice) {
  for (std::size_t i = 0; i < path.points().size(); ++i) {
    const glm::dvec3& place = path.points()[i].place;
    if (const TeResult<TePatchKey> key = tePatchAt(lattice, {place.x, place.y}); !key)
      return TeError{"--path: point " + std::to_string(i + 1) + ": " + key.error().message};
  }
  return {};
}

} // namespace

double TeFlightApp::ground(TeEngine& engine, glm::dvec2 point) {
  return teGroundAt(engine, point).value_or(0);
}

TeStatus TeFlightApp::setUp(TeEngine& engine, SoSeparator&, glm::dvec2 start) {
  if (const TeStatus ok = m_options.check(); !ok)
    return ok;
  const double ahead = (m_engine.radius + 1.5) * engine.getDatabase()->lattice().patchSide();
  m_altitude = m_options.altitude.value_or(std::min(kAltitudeShare * ahead, kHighestStart));
  if (const TeStatus ok =
          m_options.path.empty() ? addUsersAircraft(engine, start) : addPathAircraft(engine, start);
      !ok)
    return ok;
  return addCompanion(engine, start);
}

TeStatus TeFlightApp::addUsersAircraft(TeEngine& engine, glm::dvec2 start) {
  auto aircraft = std::make_unique<TeAircraft>("Your aircraft");
  m_aircraft = aircraft.get();
  if (const TeStatus ok = aircraft->setPosition({start, ground(engine, start) + m_altitude}); !ok)
    return ok;
  if (const TeStatus ok = aircraft->setVelocity({0, speed(), 0}); !ok)
    return ok;
  engine.setActiveObject(engine.addObject(std::move(aircraft)));
  return {};
}

TeResult<TePath> TeFlightApp::pathFrom(TeEngine& engine, glm::dvec2 start) const {
  if (!isPathName(m_options.path)) {
    std::error_code ignored;
    if (!std::filesystem::exists(m_options.path, ignored))
      return TeError{"--path: " + teQuoted(m_options.path) + " is no file and no built-in path" +
                     teKnownNames(m_options.path, tePathNames())};
    return TePath::read(m_options.path);
  }
  // Where a jump leads, the ground is not known at once; at an altitude the flight does not depend on when.
  if (m_options.path == "teleport")
    return teNamedPath(m_options.path, {start, ground(engine, start) + 2 * m_altitude}, false);
  return teNamedPath(m_options.path, {start, m_altitude}, true);
}

TeStatus TeFlightApp::addPathAircraft(TeEngine& engine, glm::dvec2 start) {
  TeResult<TePath> path = pathFrom(engine, start);
  if (!path)
    return path.error();
  if (const TeStatus ok = checkInWorld(*path, engine.getDatabase()->lattice()); !ok)
    return ok;
  const TePathTraveller traveller(std::move(*path), speed(), m_options.speed.has_value());
  glm::dvec3 place = traveller.place();
  if (traveller.aboveGround())
    place.z += ground(engine, {place.x, place.y});
  auto aircraft = std::make_unique<TePathAircraft>("Aircraft", traveller);
  m_aircraft = m_flown = aircraft.get();
  if (const TeStatus ok = aircraft->setPosition(place); !ok)
    return ok;
  if (const TeStatus ok = aircraft->setVelocity(traveller.direction() * traveller.speed()); !ok)
    return ok;
  engine.setActiveObject(engine.addObject(std::move(aircraft)));
  return {};
}

TeStatus TeFlightApp::addCompanion(TeEngine& engine, glm::dvec2 start) {
  const glm::dvec2 place = start + glm::dvec2(kCompanionX, 0);
  TeResult<TePath> path = teNamedPath("line", {place, m_altitude}, true);
  if (!path)
    return path.error();
  auto aircraft = std::make_unique<TePathAircraft>(
      "Companion", TePathTraveller(std::move(*path), speed() > 0 ? speed() : TeFlightOptions::kDefaultSpeed),
      kCompanionColour);
  if (const TeStatus ok = aircraft->setPosition({place, ground(engine, place) + m_altitude}); !ok)
    return ok;
  engine.addObject(std::move(aircraft));
  return {};
}

void TeFlightApp::describe(nlohmann::ordered_json& report) const {
  const glm::dvec3& position = m_aircraft->position();
  report["position_m"] = {position.x, position.y, position.z};
  report["speed_m_s"] = m_aircraft->speed();
  if (m_flown)
    report["path"] = {{"name", m_options.path},
                      {"metres", m_flown->traveller().distance()},
                      {"jumps", m_flown->traveller().jumps()},
                      {"ended", m_flown->traveller().ended()}};
}

TeEngineApp::Settings TeFlightApp::settings() const {
  return {{"path", m_options.path},
          {"speed", m_options.speed ? teNumberText(*m_options.speed) : ""},
          {"altitude", m_options.altitude ? teNumberText(*m_options.altitude) : ""}};
}
