#include "nodes/TeOverlay.h"

#include <Inventor/nodes/SoDepthBuffer.h>
#include <Inventor/nodes/SoDrawStyle.h>
#include <Inventor/nodes/SoEnvironment.h>
#include <Inventor/nodes/SoLightModel.h>
#include <Inventor/nodes/SoPickStyle.h>
#include <Inventor/nodes/SoSeparator.h>

void teAddSignState(SoSeparator& separator) {
  auto* unlit = new SoLightModel;
  unlit->model = SoLightModel::BASE_COLOR;
  separator.addChild(unlit);
  auto* fog = new SoEnvironment;
  fog->fogType = SoEnvironment::NONE;
  separator.addChild(fog);
  auto* style = new SoDrawStyle;
  style->style = SoDrawStyle::FILLED;
  separator.addChild(style);
  auto* picking = new SoPickStyle;
  picking->style = SoPickStyle::UNPICKABLE;
  separator.addChild(picking);
}

void teAddOverlayState(SoSeparator& separator) {
  auto* depth = new SoDepthBuffer;
  depth->test = FALSE;
  depth->write = FALSE;
  separator.addChild(depth);
  teAddSignState(separator);
}
