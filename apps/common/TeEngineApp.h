#pragma once

#include "engine/input/TeKeyEvent.h"
#include "generators/base/TeResult.h"

#include <glm/vec2.hpp>
#include <nlohmann/json.hpp>

#include <map>
#include <optional>
#include <string>

class SoSeparator;
class TeEngine;

/// What one application adds to a run of the engine (TeEngineRun): its objects, its keys, its figures.
class TeEngineApp {
public:
  /// Values by name; names have no spaces.
  using Settings = std::map<std::string, std::string>;

  virtual ~TeEngineApp() = default;

  /// Adds objects and makes one of them active. The engine has its terrain and budget, but is not initialised
  /// yet; `scene` has camera, light and haze; `start` is where the terrain's middle is. An error ends the run
  /// with TeExitUsage.
  virtual TeStatus setUp(TeEngine& engine, SoSeparator& scene, glm::dvec2 start) = 0;
  /// Before a tick of `dt` seconds of a run that is not paused.
  virtual void beforeTick(double /*dt*/) {}
  /// After every tick, before its frame is drawn.
  virtual void afterTick() {}
  /// A key that neither the active object, the camera nor the engine uses; true if it meant something.
  virtual bool handleKey(const TeKeyEvent& /*event*/) { return false; }
  /// Adds the application's own figures to the report, at the end of the run.
  virtual void describe(nlohmann::ordered_json& /*report*/) const {}
  /// Options of its own that decide what happens: a recording keeps them, and a replay must have the same.
  virtual Settings settings() const { return {}; }
};

/// Height of the ground at a point, whose patch is built at once if it was not known. None where elevation
/// data is missing. For placing objects before the first tick.
std::optional<double> teGroundAt(TeEngine& engine, glm::dvec2 point);
