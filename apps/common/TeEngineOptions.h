#pragma once

#include "apps/common/TeTerrainOptions.h"
#include "engine/TeEngine.h"

#include <glm/vec2.hpp>

#include <optional>
#include <string>

/// The options of every application of the engine, besides the common ones.
struct TeEngineOptions {
  static constexpr int kMaxUnits = 1'000'000;
  /// Units of work that take a little less than TeEngine::kDefaultBudget: the allowance of runs with --dt.
  static constexpr int kDefaultUnits = 64;
  static constexpr double kLeastPixelError = 0.01;

  TeTerrainOptions terrain;
  glm::dvec2 center{0}; ///< where to begin, metres
  int radius = 1;
  double budget = TeEngine::kDefaultBudget * 1000; ///< milliseconds a tick
  int units = 0;         ///< of work a tick; 0 = by time, or kDefaultUnits with --dt
  double fps = 0;        ///< wanted frames a second; 0 = none
  double pixelError = 0; ///< 0 = all triangles, or with fps as it needs
  int workers = 0;
  std::string record; ///< file; empty = none
  std::string replay;
  std::string haze = "auto"; ///< on, off, or auto = on beyond radius 1
  bool hud = true;
  bool thirdPerson = false;
  std::string screenshots = "."; ///< folder

  /// Adds the options to a command line, which reads them into this object when it is parsed.
  void addTo(TeCommandLine& commandLine);
  /// What contradicts what; after parsing.
  TeStatus check(const TeCommonOptions& common) const;

  bool hazy() const { return haze == "on" || (haze == "auto" && radius > 1); }
  /// Sets an engine's accuracy, and what time it has. Runs with --dt do not go by the clock: fps counts for
  /// nothing then.
  SbBool apply(TeEngine& engine, const TeCommonOptions& common) const;
  /// The work units of a tick; 0 = by time.
  int unitBudget(const TeCommonOptions& common) const;
};
