#pragma once

#include "engine/TeStatistics.h"

#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <vector>

class TeEngine;

/// What a run of the engine has done, tick by tick, for the report.
class TeEngineLog {
public:
  /// A jump is a move of more than `patchSide` metres beyond what the velocity explains.
  explicit TeEngineLog(double patchSide) : m_patchSide(patchSide) {}

  /// After a tick of `dt` seconds.
  void ticked(const TeEngine& engine, double dt);
  /// After TeEngine::frameDrawn().
  void drawn(const TeEngine& engine);

  /// Adds all figures of the engine to a report.
  void describe(const TeEngine& engine, nlohmann::ordered_json& report) const;

private:
  void watchGround(const TeEngine& engine, double dt);

  double m_patchSide;
  std::vector<float> m_tickMilliseconds; ///< finished ticks
  bool m_tickOpen = false;
  std::int64_t m_uploads = 0;
  std::int64_t m_uploadedBytes = 0;
  double m_uploadSeconds = 0;
  double m_errorBound = 0; ///< the largest of all frames
  double m_leastError = 0; ///< wanted
  double m_mostError = 0;
  std::int64_t m_frames = 0;
  // Jumps of the active object.
  bool m_known = false;
  glm::dvec3 m_position{0};
  std::int64_t m_withoutGround = 0; ///< ticks in a row
  std::int64_t m_withoutGroundBefore = 0;
  std::int64_t m_teleports = 0;
  std::int64_t m_mostTicksUntilGround = 0;
};
