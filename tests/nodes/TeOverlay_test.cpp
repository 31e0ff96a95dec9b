#include "nodes/TeOverlay.h"

#include "nodes/TeNodePtr.h"

#include <Inventor/SoPickedPoint.h>
#include <Inventor/actions/SoCallbackAction.h>
#include <Inventor/actions/SoRayPickAction.h>
#include <Inventor/elements/SoDrawStyleElement.h>
#include <Inventor/elements/SoEnvironmentElement.h>
#include <Inventor/elements/SoLazyElement.h>
#include <Inventor/nodes/SoCube.h>
#include <Inventor/nodes/SoDrawStyle.h>
#include <Inventor/nodes/SoEnvironment.h>
#include <Inventor/nodes/SoSeparator.h>

#include <gtest/gtest.h>

#include <utility>

namespace {

TEST(TeOverlay, IsNeverPicked) {
  const TeNodePtr<SoSeparator> root(new SoSeparator);
  auto* overlay = new SoSeparator;
  root->addChild(overlay);
  auto* cube = new SoCube;
  teAddOverlayState(*overlay);
  overlay->addChild(cube);

  SoRayPickAction pick(SbViewportRegion(10, 10));
  pick.setRay(SbVec3f(0, 0, 10), SbVec3f(0, 0, -1));
  pick.apply(root.get());
  EXPECT_EQ(pick.getPickedPoint(), nullptr);
  overlay->removeAllChildren();
  overlay->addChild(new SoCube);
  pick.apply(root.get());
  EXPECT_NE(pick.getPickedPoint(), nullptr) << "without it the cube is picked";
}

TEST(TeOverlay, HasNoLight) {
  const TeNodePtr<SoSeparator> root(new SoSeparator);
  teAddOverlayState(*root);
  root->addChild(new SoCube);
  SoLazyElement::LightModel model = SoLazyElement::PHONG;
  SoCallbackAction action(SbViewportRegion(10, 10));
  action.addPreCallback(
      SoCube::getClassTypeId(),
      [](void* found, SoCallbackAction* at, const SoNode*) {
        *static_cast<SoLazyElement::LightModel*>(found) =
            SoLazyElement::LightModel(SoLazyElement::getLightModel(at->getState()));
        return SoCallbackAction::CONTINUE;
      },
      &model);
  action.apply(root.get());
  EXPECT_EQ(model, SoLazyElement::BASE_COLOR);
}

TEST(TeOverlay, HasNoFogAndIsFilledWhateverTheSceneIs) {
  const TeNodePtr<SoSeparator> root(new SoSeparator);
  auto* fog = new SoEnvironment;
  fog->fogType = SoEnvironment::FOG;
  root->addChild(fog);
  auto* lines = new SoDrawStyle;
  lines->style = SoDrawStyle::LINES;
  root->addChild(lines);
  teAddOverlayState(*root);
  root->addChild(new SoCube);
  std::pair<int, int> found{-1, -1};
  SoCallbackAction action(SbViewportRegion(10, 10));
  action.addPreCallback(
      SoCube::getClassTypeId(),
      [](void* data, SoCallbackAction* at, const SoNode*) {
        *static_cast<std::pair<int, int>*>(data) = {SoEnvironmentElement::getFogType(at->getState()),
                                                    SoDrawStyleElement::get(at->getState())};
        return SoCallbackAction::CONTINUE;
      },
      &found);
  action.apply(root.get());
  EXPECT_EQ(found.first, SoEnvironmentElement::NONE);
  EXPECT_EQ(found.second, SoDrawStyleElement::FILLED);
}

} // namespace
