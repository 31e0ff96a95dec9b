#pragma once

#include "apps/terrane-view/TeFlyCamera.h"
#include "apps/terrane-view/TeViewContent.h"
#include "apps/terrane-view/TeViewPath.h"

#include <nlohmann/json.hpp>

#include <optional>

/// Where the user's eye is: on a path, or flown by keys and mouse.
class TeViewFlight {
public:
  /// The content outlives it. Error: no such path.
  static TeResult<TeViewFlight> create(const TeViewContent& content, const TeViewOptions& options);

  const TeViewPose& pose() const { return m_path ? m_path->pose() : m_camera.pose(); }
  bool moving() const { return m_path ? !m_path->traveller().ended() : m_camera.moving(); }
  /// Seconds.
  void update(double dt);
  /// On a path neither keys nor the mouse do anything.
  TeFlyCamera* camera() { return m_path ? nullptr : &m_camera; }
  void releaseKeys() { m_camera.releaseKeys(); }

  void describe(nlohmann::ordered_json& report) const;

private:
  explicit TeViewFlight(TeFlyCamera camera) : m_camera(std::move(camera)) {}

  TeFlyCamera m_camera;
  std::optional<TeViewPath> m_path;
};
