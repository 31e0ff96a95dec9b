#pragma once

#include "apps/terrane-view/TeViewGround.h"
#include "apps/terrane-view/TeViewOptions.h"
#include "apps/terrane-view/TeViewPose.h"

#include <memory>
#include <optional>
#include <string>

/// What is shown: a scene or a terrain in world coordinates, z up, without camera.
struct TeViewContent {
  TeNodePtr<SoSeparator> root;
  glm::dvec3 low{-1}; ///< box
  glm::dvec3 high{1};
  std::unique_ptr<TeViewGround> ground;
  std::optional<TeViewPose> start; ///< of the scene's own camera
  double heightAngle = 0;          ///< of that camera, radians; 0 = as usual
  bool lit = false;                ///< has lights of its own
  std::string description;

  glm::dvec3 middle() const { return 0.5 * (low + high); }
  /// The longer of its level sides, or its height if that is more; above 0.
  double size() const;

  /// Reads what the options name. Error: bad options or input. After TeNodes::init().
  static TeResult<TeViewContent> create(const TeViewOptions& options, bool quiet);

private:
  static TeResult<TeViewContent> fromScene(const TeViewOptions& options);
  static TeResult<TeViewContent> fromDem(const TeViewOptions& options, bool quiet);
  static TeResult<TeViewContent> fromClipmaps(const TeViewOptions& options);
};
