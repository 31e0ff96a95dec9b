#include "apps/common/TeHaze.h"

#include <Inventor/actions/SoGLRenderAction.h>
#include <Inventor/elements/SoEnvironmentElement.h>
#include <Inventor/nodes/SoCallback.h>
#include <Inventor/nodes/SoEnvironment.h>
#include <Inventor/nodes/SoGroup.h>

namespace {

constexpr float kBegin = 0.35f; ///< of the visibility

/// Begins the haze of the state at that part of its visibility.
void begin(void*, SoAction* action) {
  if (!action->isOfType(SoGLRenderAction::getClassTypeId()))
    return;
  SoState* state = action->getState();
  float ambient, visibility, start;
  SbColor ambientColour, fogColour;
  SbVec3f attenuation;
  int32_t type;
  SoEnvironmentElement::get(state, ambient, ambientColour, attenuation, type, fogColour, visibility, start);
  start = kBegin * visibility;
  SoEnvironmentElement::set(state, action->getCurPathTail(), ambient, ambientColour, attenuation, type,
                            fogColour, visibility, start);
}

} // namespace

SoNode* teHaze(const SbColor& colour, float visibility) {
  auto* haze = new SoGroup;
  auto* environment = new SoEnvironment;
  environment->fogType = SoEnvironment::HAZE;
  environment->fogColor = colour;
  environment->fogVisibility = visibility;
  haze->addChild(environment);
  auto* later = new SoCallback;
  later->setCallback(begin);
  haze->addChild(later);
  return haze;
}
