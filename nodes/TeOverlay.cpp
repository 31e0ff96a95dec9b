#include "nodes/TeOverlay.h"

#include <Inventor/nodes/SoDepthBuffer.h>
#include <Inventor/nodes/SoLightModel.h>
#include <Inventor/nodes/SoPickStyle.h>
#include <Inventor/nodes/SoSeparator.h>

void teAddOverlayState(SoSeparator& separator) {
  auto* depth = new SoDepthBuffer;
  depth->test = FALSE;
  depth->write = FALSE;
  separator.addChild(depth);
  auto* unlit = new SoLightModel;
  unlit->model = SoLightModel::BASE_COLOR;
  separator.addChild(unlit);
  auto* picking = new SoPickStyle;
  picking->style = SoPickStyle::UNPICKABLE;
  separator.addChild(picking);
}
