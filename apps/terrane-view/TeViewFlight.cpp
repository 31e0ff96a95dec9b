#include "apps/terrane-view/TeViewFlight.h"

#include "apps/terrane-view/TeViewStage.h"

#include <algorithm>

namespace {

constexpr double kAltitude = 0.02; ///< of the side

TeViewPose startOf(const TeViewContent& content, const TeViewOptions& options) {
  const TeViewPose usual = content.start.value_or(TeViewStage::overview(content));
  if (!options.eye && !options.look)
    return usual;
  return TeViewPose::towards(options.eye.value_or(usual.eye), options.look.value_or(content.middle()));
}

} // namespace

TeResult<TeViewFlight> TeViewFlight::create(const TeViewContent& content, const TeViewOptions& options) {
  const TeViewGround* ground = content.ground.get();
  TeViewFlight flight(TeFlyCamera(startOf(content, options), content.size(), ground));
  if (options.path.empty())
    return flight;
  const glm::dvec3 sides = content.high - content.low;
  const double side = std::max(std::min(sides.x, sides.y), 1e-3);
  TeResult<TeViewPath> path =
      TeViewPath::create(options.path, content.middle(), side, options.altitude.value_or(kAltitude * side),
                         options.speed.value_or(0), ground);
  if (!path)
    return path.error();
  flight.m_path = std::move(*path);
  return flight;
}

void TeViewFlight::update(double dt) {
  if (m_path)
    m_path->update(dt);
  else
    m_camera.update(dt);
}

void TeViewFlight::describe(nlohmann::ordered_json& report) const {
  const glm::dvec3 eye = pose().eye, ahead = pose().forward();
  report["eye_m"] = {eye.x, eye.y, eye.z};
  report["direction"] = {ahead.x, ahead.y, ahead.z};
  if (m_path)
    report["path"] = {{"metres", m_path->traveller().distance()},
                      {"speed_m_s", m_path->traveller().speed()},
                      {"jumps", m_path->traveller().jumps()},
                      {"ended", m_path->traveller().ended()}};
}
