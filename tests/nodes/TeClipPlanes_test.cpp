#include "nodes/TeClipPlanes.h"

#include "nodes/TeNodePtr.h"

#include <Inventor/SbViewportRegion.h>
#include <Inventor/nodes/SoCube.h>
#include <Inventor/nodes/SoOrthographicCamera.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>
#include <Inventor/nodes/SoRotationXYZ.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoTranslation.h>

#include <gtest/gtest.h>

namespace {

/// A cube of side 2 around (0, 0, -z) after a camera at the origin that looks along -z.
template <class Camera> TeNodePtr<SoSeparator> cubeAt(float z, Camera*& camera) {
  TeNodePtr<SoSeparator> root(new SoSeparator);
  camera = new Camera;
  camera->position.setValue(0, 0, 0);
  root->addChild(camera);
  auto* translation = new SoTranslation;
  translation->translation.setValue(0, 0, -z);
  root->addChild(translation);
  root->addChild(new SoCube);
  return root;
}

const SbViewportRegion kViewport(100, 100);

} // namespace

TEST(TeClipPlanes, EncloseTheScene) {
  SoPerspectiveCamera* camera = nullptr;
  const auto root = cubeAt(10, camera);
  ASSERT_TRUE(teFitClipPlanes(root.get(), kViewport));
  EXPECT_LT(camera->nearDistance.getValue(), 9);
  EXPECT_GT(camera->nearDistance.getValue(), 8);
  EXPECT_GT(camera->farDistance.getValue(), 11);
  EXPECT_LT(camera->farDistance.getValue(), 12);
}

TEST(TeClipPlanes, KeepWhatIsCloseToTheEye) {
  SoPerspectiveCamera* camera = nullptr;
  const auto root = cubeAt(1.2f, camera);
  ASSERT_TRUE(teFitClipPlanes(root.get(), kViewport));
  EXPECT_LT(camera->nearDistance.getValue(), 0.2f);
  EXPECT_GT(camera->nearDistance.getValue(), 0);
}

TEST(TeClipPlanes, PerspectiveStaysInFrontOfTheEye) {
  SoPerspectiveCamera* camera = nullptr;
  for (float z : {0.0f, -10.0f, 1e6f}) {
    const auto root = cubeAt(z, camera);
    ASSERT_TRUE(teFitClipPlanes(root.get(), kViewport));
    EXPECT_GT(camera->nearDistance.getValue(), 0) << z;
    EXPECT_GT(camera->farDistance.getValue(), camera->nearDistance.getValue()) << z;
  }
}

TEST(TeClipPlanes, OrthographicMayLookBehindItself) {
  SoOrthographicCamera* camera = nullptr;
  const auto root = cubeAt(-10, camera);
  ASSERT_TRUE(teFitClipPlanes(root.get(), kViewport));
  EXPECT_LT(camera->nearDistance.getValue(), -11);
  EXPECT_GT(camera->farDistance.getValue(), -9);
}

TEST(TeClipPlanes, FollowTransformedCameras) {
  TeNodePtr<SoSeparator> root(new SoSeparator);
  auto* rotation = new SoRotationXYZ; // the camera now looks along +x
  rotation->axis = SoRotationXYZ::Y;
  rotation->angle = float(-M_PI / 2);
  root->addChild(rotation);
  auto* camera = new SoPerspectiveCamera;
  camera->position.setValue(0, 0, 0);
  root->addChild(camera);
  auto* translation = new SoTranslation;
  translation->translation.setValue(0, 0, -10);
  root->addChild(translation);
  root->addChild(new SoCube);
  ASSERT_TRUE(teFitClipPlanes(root.get(), kViewport));
  EXPECT_NEAR(camera->nearDistance.getValue(), 9, 0.1);
  EXPECT_NEAR(camera->farDistance.getValue(), 11, 0.1);
}

TEST(TeClipPlanes, NoCameraIsAnError) {
  TeNodePtr<SoSeparator> root(new SoSeparator);
  root->addChild(new SoCube);
  EXPECT_FALSE(teFitClipPlanes(root.get(), kViewport));
}
