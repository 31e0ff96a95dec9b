#pragma once

#include <Inventor/nodes/SoDirectionalLight.h>
#include <Inventor/nodes/SoGroup.h>

/// Adds a light that shines in a direction.
inline void teAddLight(SoGroup& scene, const SbVec3f& direction, const SbColor& colour, float intensity) {
  auto* light = new SoDirectionalLight;
  light->direction = direction;
  light->color = colour;
  light->intensity = intensity;
  scene.addChild(light);
}
