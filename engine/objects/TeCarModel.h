#pragma once

#include "engine/objects/TeCarGeometry.h"
#include "nodes/TeNodePtr.h"

#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoTransform.h>

/// What a car looks like: an open off-road car of few triangles, with wheels that move. In the car's frame;
/// its sides are seen from outside only, so that it is no obstacle to a camera on the driver's seat.
class TeCarModel {
public:
  TeCarModel();

  SoSeparator* root() const { return m_root.get(); }
  /// travel: metres up; steering: tangent of the angle to the left; turned: radians forward.
  void setWheel(int wheel, double travel, double steering, double turned);

private:
  struct Wheel {
    TeNodePtr<SoTransform> hub;  ///< suspension and steering
    TeNodePtr<SoTransform> axle; ///< rolling
  };

  TeNodePtr<SoSeparator> m_root;
  std::array<Wheel, TeCarGeometry::kWheels> m_wheels;
};
