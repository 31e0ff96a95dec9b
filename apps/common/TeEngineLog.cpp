#include "apps/common/TeEngineLog.h"

#include "engine/TeEngine.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace {

using Json = nlohmann::ordered_json;

Json describeJobs(const TeStatistics::Jobs& jobs) {
  Json json;
  for (int kind = 0; kind < kTeJobKinds; ++kind) {
    const std::size_t k = std::size_t(kind);
    Json& of = json[teJobKindName(TeJobKind(kind))];
    of = {{"started", jobs.started[k]},
          {"finished", jobs.finished[k]},
          {"cancelled", jobs.cancelled[k]},
          {"failed", jobs.failed[k]}};
    for (int state = 0; state < kTeJobStates; ++state)
      of["now"][teJobStateName(TeJobState(state))] = jobs.now[k][std::size_t(state)];
  }
  json["maps_made"] = jobs.mapsMade;
  json["maps_shared"] = jobs.mapsShared;
  return json;
}

Json describeMemory(const TeStatistics::Memory& memory) {
  return {{"maps", memory.maps},
          {"heights", memory.heights},
          {"meshes", memory.meshes},
          {"buffers", memory.buffers},
          {"records", memory.records}};
}

} // namespace

void TeEngineLog::ticked(const TeEngine& engine, double dt) {
  // A tick's time is complete with the uploads of its frame, or when the next one begins.
  m_tickOpen = true;
  watchGround(engine, dt);
}

void TeEngineLog::watchGround(const TeEngine& engine, double dt) {
  const TeObject& object = *engine.getActiveObject();
  const double moved = glm::distance(object.position(), m_position);
  if (m_known && moved > 2 * glm::length(object.velocity()) * dt + m_patchSide)
    ++m_teleports;
  m_position = object.position();
  m_known = true;
  const std::int64_t without = engine.getStatistics().framesWithoutGround;
  m_withoutGround = without > m_withoutGroundBefore ? m_withoutGround + 1 : 0;
  m_withoutGroundBefore = without;
  m_mostTicksUntilGround = std::max(m_mostTicksUntilGround, m_withoutGround);
}

void TeEngineLog::drawn(const TeEngine& engine) {
  const TeStatistics& statistics = engine.getStatistics();
  if (std::exchange(m_tickOpen, false))
    m_tickMilliseconds.push_back(float(1000 * statistics.tickSeconds));
  m_errorBound = std::max(m_errorBound, statistics.errorBoundPixels);
  m_leastError = m_frames > 0 ? std::min(m_leastError, statistics.pixelError) : statistics.pixelError;
  m_mostError = std::max(m_mostError, statistics.pixelError);
  ++m_frames;
  m_uploads += statistics.drawing.uploads;
  m_uploadedBytes += statistics.drawing.bytesUploaded;
  m_uploadSeconds += statistics.drawing.uploadSeconds;
}

void TeEngineLog::describe(const TeEngine& engine, Json& report) const {
  const TeStatistics& statistics = engine.getStatistics();
  std::vector<float> ticks = m_tickMilliseconds;
  const auto middle = ticks.begin() + std::ptrdiff_t(ticks.size() / 2);
  std::nth_element(ticks.begin(), middle, ticks.end());
  report["ticks"] = statistics.ticks;
  report["simulated_seconds"] = statistics.simulatedSeconds;
  report["dropped_seconds"] = statistics.droppedSeconds;
  report["budget_ms"] = 1000 * statistics.budgetSeconds;
  report["ticks_over_budget"] = statistics.ticksOverBudget;
  report["worst_tick_ms"] = 1000 * statistics.worstTickSeconds;
  report["median_tick_ms"] = ticks.empty() ? 0.0f : *middle;
  report["slices_overrun"] = statistics.slicesOverrun;
  report["longest_unit_ms"] = 1000 * statistics.longestUnitSeconds;
  report["frames_without_ground"] = statistics.framesWithoutGround;
  report["frames_with_missing_in_view"] = statistics.framesWithMissingInView;
  report["frames_with_missing_later"] = statistics.framesWithMissingLater;
  report["ticks_until_complete"] = statistics.ticksUntilComplete;
  report["updates_held"] = statistics.objectsHeld;
  report["teleports"] = {{"count", m_teleports}, {"most_ticks_until_ground", m_mostTicksUntilGround}};
  report["redraws"] = statistics.redraws;
  report["triangles"] = statistics.drawing.triangles;
  report["pixel_error"] = statistics.pixelError;
  report["pixel_error_range"] = {m_leastError, m_mostError};
  report["error_bound"] = m_errorBound;
  report["frame_goal_ms"] = 1000 * statistics.frameGoalSeconds;
  report["jobs"] = describeJobs(statistics.jobs);
  const TeStatistics::Patches& patches = statistics.patches;
  report["patches"] = {{"resident", patches.resident},
                       {"block", patches.block},
                       {"drawn", patches.drawn},
                       {"missing", patches.missing},
                       {"missing_in_view", patches.missingInView},
                       {"made", patches.made},
                       {"made_again", patches.madeAgain},
                       {"dropped", patches.dropped}};
  report["uploads"] = {{"count", m_uploads}, {"bytes", m_uploadedBytes}, {"ms", 1000 * m_uploadSeconds}};
  report["memory_bytes"] = describeMemory(statistics.memory);
  report["memory_peak_bytes"] = describeMemory(statistics.peak);
}
