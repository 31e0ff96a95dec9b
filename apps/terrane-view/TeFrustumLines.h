#pragma once

#include "apps/terrane-view/TeViewPose.h"
#include "nodes/TeNodePtr.h"

#include <Inventor/nodes/SoCoordinate3.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoSwitch.h>

/// Lines along the edges of what a camera sees, up to a distance.
class TeFrustumLines {
public:
  TeFrustumLines();

  SoSwitch* node() const { return m_switch.get(); }
  void setShown(bool shown);
  /// `tangentX`, `tangentY`: of half the angles of view.
  void set(const TeViewPose& pose, double tangentX, double tangentY, double distance);

private:
  TeNodePtr<SoSwitch> m_switch;
  SoCoordinate3* m_points; ///< belongs to m_switch
};
