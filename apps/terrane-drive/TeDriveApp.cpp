#include "apps/terrane-drive/TeDriveApp.h"

#include "engine/TeEngine.h"
#include "generators/base/TeText.h"

#include <cmath>

namespace {

/// A place nearby where a car stands well: the first one on a spiral, else the most level one.
TeResult<glm::dvec2> parkingPlace(TeEngine& engine, glm::dvec2 start) {
  constexpr int kPlaces = 64;
  constexpr double kLevel = 0.25; ///< rise over run
  std::optional<glm::dvec2> best;
  double least = 0;
  glm::dvec2 arm(0);
  for (int i = 0; i < kPlaces; ++i) {
    const glm::dvec2 place = start + arm;
    // The next arm is turned by about the golden angle and is longer.
    arm = i == 0 ? glm::dvec2(0, 3)
                 : glm::dvec2(-0.74 * arm.x - 0.67 * arm.y, 0.67 * arm.x - 0.74 * arm.y) * 1.03;
    bool known = true;
    for (const glm::dvec2 corner :
         {glm::dvec2(-2, -2), glm::dvec2(2, -2), glm::dvec2(-2, 2), glm::dvec2(2, 2)})
      known = known && teGroundAt(engine, place + corner);
    if (!known)
      continue;
    const TeCarStance stance = TeCarStance::on(*engine.getDatabase(), place, {0, 1}, 0);
    const double strain = stance.complete() ? stance.strain() : INFINITY;
    if (!best || strain < least) {
      best = place;
      least = strain;
    }
    if (strain * TeCarGeometry::kSteepest <= kLevel)
      break;
  }
  if (best)
    return *best;
  return TeError{teFormat("--center %g,%g: no ground to put a car on", start.x, start.y)};
}

/// What the car may see of the ground from the first tick on, so that a run does not depend on how soon the
/// engine makes it. Where there is none the car finds out by itself.
void buildAround(TeEngine& engine, glm::dvec2 place) {
  const double side = engine.getDatabase()->lattice().patchSide();
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x)
      (void)teGroundAt(engine, place + side * glm::dvec2(x, y));
}

} // namespace

void TeDriveApp::addTo(TeCommandLine& commandLine) {
  commandLine.cli().add_flag("--auto", m_auto, "The car drives by itself")->group("Car");
}

TeStatus TeDriveApp::setUp(TeEngine& engine, SoSeparator&, glm::dvec2 start) {
  const TeResult<glm::dvec2> place = parkingPlace(engine, start);
  if (!place)
    return place.error();
  buildAround(engine, *place);
  if (m_colours)
    engine.setColours(*m_colours);
  auto car = std::make_unique<TeCar>("car");
  if (TeStatus ok = car->setPosition({*place, teGroundAt(engine, *place).value_or(0)}); !ok)
    return ok;
  car->setAuto(m_auto);
  m_engine = &engine;
  m_car = static_cast<TeCar*>(engine.addObject(std::move(car)));
  if (!m_car || !engine.setActiveObject(m_car))
    return TeError{engine.lastError()};
  return {};
}

void TeDriveApp::afterTick() { m_wheels.look(*m_car, *m_engine->getDatabase()); }

void TeDriveApp::describe(nlohmann::ordered_json& report) const {
  m_wheels.describe(report);
  report["distance_m"] = m_car->distanceDriven();
  report["blocked"] = m_car->blocked();
}

TeEngineApp::Settings TeDriveApp::settings() const { return {{"auto", m_auto ? "1" : "0"}}; }
