#pragma once

#include "apps/common/TeEngineApp.h"
#include "apps/common/TeEngineOptions.h"
#include "apps/terrane-flight/TeFlightOptions.h"
#include "engine/paths/TePath.h"

class TeAircraft;
class TePathAircraft;

/// The flight demo: the user's aircraft, or one that flies a path, and another one 60 m to its left.
class TeFlightApp : public TeEngineApp {
public:
  /// Both outlive it, and are read once the command line has been parsed.
  TeFlightApp(const TeFlightOptions& options, const TeEngineOptions& engine)
      : m_options(options), m_engine(engine) {}

  TeStatus setUp(TeEngine& engine, SoSeparator& scene, glm::dvec2 start) override;
  void describe(nlohmann::ordered_json& report) const override;
  Settings settings() const override;

private:
  double speed() const { return m_options.speed.value_or(TeFlightOptions::kDefaultSpeed); }
  /// The ground, or 0 where there is none.
  static double ground(TeEngine& engine, glm::dvec2 point);
  TeResult<TePath> pathFrom(TeEngine& engine, glm::dvec2 start) const;
  TeStatus addPathAircraft(TeEngine& engine, glm::dvec2 start);
  TeStatus addUsersAircraft(TeEngine& engine, glm::dvec2 start);
  TeStatus addCompanion(TeEngine& engine, glm::dvec2 start);

  const TeFlightOptions& m_options;
  const TeEngineOptions& m_engine;
  double m_altitude = 0;
  const TeAircraft* m_aircraft = nullptr;
  const TePathAircraft* m_flown = nullptr; ///< the same, if it flies a path
};
