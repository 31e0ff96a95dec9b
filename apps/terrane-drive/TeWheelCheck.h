#pragma once

#include "engine/objects/TeCar.h"

#include <nlohmann/json.hpp>

/// Measures in every frame how far a car's wheels are from the surface of the terrain, and where it has been.
class TeWheelCheck {
public:
  /// The car as it is now.
  void look(const TeCar& car, const TePatchDatabase& terrain);
  void describe(nlohmann::ordered_json& report) const;

private:
  double m_worstGap = 0; ///< metres, over all frames and wheels
  double m_worstTravel = 0;
  std::int64_t m_frames = 0;          ///< in which all wheels had known ground
  std::int64_t m_framesInTheAir = 0;  ///< in which one had none
  std::int64_t m_bordersCrossed = 0;  ///< of patches, by the middle of the car
  std::int64_t m_wheelsOnBorders = 0; ///< wheels that stood on another patch than the middle
  std::optional<TePatchKey> m_patch;
};
