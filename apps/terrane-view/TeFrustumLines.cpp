#include "apps/terrane-view/TeFrustumLines.h"

#include "nodes/TeOverlay.h"

#include <Inventor/nodes/SoBaseColor.h>
#include <Inventor/nodes/SoDrawStyle.h>
#include <Inventor/nodes/SoIndexedLineSet.h>

namespace {

constexpr int kCorners = 5; ///< the eye, then around the far end
const SbColor kColour(1, 0.45f, 0.05f);
constexpr float kWidth = 2; ///< pixels

} // namespace

TeFrustumLines::TeFrustumLines() : m_switch(new SoSwitch), m_points(new SoCoordinate3) {
  auto* lines = new SoSeparator;
  teAddSignState(*lines);
  auto* colour = new SoBaseColor;
  colour->rgb = kColour;
  lines->addChild(colour);
  auto* style = new SoDrawStyle;
  style->lineWidth = kWidth;
  lines->addChild(style);
  lines->addChild(m_points);
  auto* edges = new SoIndexedLineSet;
  const int32_t indices[] = {0, 1, 2, 3, 4, 1, -1, 2, 0, 3, -1, 4, 0, -1};
  edges->coordIndex.setValues(0, int(sizeof indices / sizeof *indices), indices);
  lines->addChild(edges);
  m_switch->addChild(lines);
}

void TeFrustumLines::setShown(bool shown) {
  const int child = shown ? SO_SWITCH_ALL : SO_SWITCH_NONE;
  if (m_switch->whichChild.getValue() != child)
    m_switch->whichChild = child;
}

void TeFrustumLines::set(const TeViewPose& pose, double tangentX, double tangentY, double distance) {
  SbVec3f points[kCorners];
  const double across[kCorners] = {0, -1, 1, 1, -1}, upward[kCorners] = {0, -1, -1, 1, 1};
  for (int i = 0; i < kCorners; ++i) {
    const glm::dvec3 away(across[i] * tangentX, upward[i] * tangentY, -1);
    const glm::dvec3 point = pose.eye + (i == 0 ? 0.0 : distance) * (pose.orientation * away);
    points[i] = SbVec3f(float(point.x), float(point.y), float(point.z));
  }
  m_points->point.setValues(0, kCorners, points);
}
