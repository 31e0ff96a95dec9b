#pragma once

#include "nodes/TeNodePtr.h"
#include "nodes/terrain/TeBlockGraph.h"

#include <Inventor/nodes/SoDirectionalLight.h>
#include <Inventor/nodes/SoOrthographicCamera.h>
#include <Inventor/nodes/SoSeparator.h>

/// A scene seen straight from above, north up: a square picture shows `side` metres around (0, 0).
inline TeNodePtr<SoSeparator> topView(SoNode* graph, double side, const SbVec3f& light = SbVec3f(0, 0, -1)) {
  TeNodePtr<SoSeparator> scene(new SoSeparator);
  auto* camera = new SoOrthographicCamera;
  camera->position.setValue(0, 0, 1000);
  camera->height = float(side);
  scene->addChild(camera);
  auto* sun = new SoDirectionalLight;
  sun->direction = light;
  scene->addChild(sun);
  scene->addChild(graph);
  return scene;
}
