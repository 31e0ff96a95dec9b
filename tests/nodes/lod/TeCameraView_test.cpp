#include "nodes/lod/TeCameraView.h"

#include "nodes/TeNodePtr.h"
#include "nodes/readScene.h"

#include <Inventor/SbMatrix.h>
#include <Inventor/SbViewVolume.h>
#include <Inventor/actions/SoCallbackAction.h>
#include <Inventor/actions/SoGetPrimitiveCountAction.h>
#include <Inventor/nodes/SoCallback.h>
#include <Inventor/nodes/SoOrthographicCamera.h>
#include <Inventor/nodes/SoPerspectiveCamera.h>

#include <glm/geometric.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>

namespace {

const SbVec2s kPixels(1024, 768);
constexpr double kPi = 3.14159265358979323846;

SbViewVolume perspective(float degrees, const SbVec3f& position = SbVec3f(0, 0, 0), float nearest = 1,
                         float farthest = 1000) {
  TeNodePtr<SoPerspectiveCamera> camera(new SoPerspectiveCamera);
  camera->position = position;
  camera->heightAngle = float(degrees * kPi / 180);
  camera->nearDistance = nearest;
  camera->farDistance = farthest;
  return camera->getViewVolume(4.0f / 3);
}

glm::dvec3 random(std::mt19937& numbers, double size) {
  std::uniform_real_distribution<double> one(-size, size);
  return {one(numbers), one(numbers), one(numbers)};
}

/// Calls back in the state of an action that comes to the scene's node TestHere.
void inState(SoNode* scene, SoAction& action, const std::function<void(SoState*)>& look) {
  auto* here = static_cast<SoCallback*>(SoNode::getByName("TestHere"));
  ASSERT_TRUE(here);
  here->setCallback(
      [](void* data, SoAction* action) {
        (*static_cast<const std::function<void(SoState*)>*>(data))(action->getState());
      },
      const_cast<std::function<void(SoState*)>*>(&look));
  action.apply(scene);
}

} // namespace

TEST(TeCameraView, FocalIsTheSizeInPixelsOfAMetreAtOneMetre) {
  const auto view = TeCameraView::create(perspective(60), kPixels, SbMatrix::identity());
  ASSERT_TRUE(view);
  EXPECT_TRUE(view->perspective);
  EXPECT_NEAR(view->focal, 665.1, 0.05); // as in the plan of measurements: 768 / 2 / tan 30°
  EXPECT_NEAR(glm::length(view->eye), 0, 1e-6);
  EXPECT_EQ(view->slack, 0);
  for (const float degrees : {0.001f, 1.0f, 120.0f, 179.0f}) {
    const auto extreme = TeCameraView::create(perspective(degrees), kPixels, SbMatrix::identity());
    ASSERT_TRUE(extreme) << degrees;
    const double wanted = 768 / 2.0 / std::tan(double(degrees) * kPi / 360);
    EXPECT_NEAR(extreme->focal / wanted, 1, 1e-4) << degrees;
  }
}

TEST(TeCameraView, AnOrthographicCameraHasOneScaleEverywhere) {
  TeNodePtr<SoOrthographicCamera> camera(new SoOrthographicCamera);
  camera->height = 384;
  const auto view = TeCameraView::create(camera->getViewVolume(4.0f / 3), kPixels, SbMatrix::identity());
  ASSERT_TRUE(view);
  EXPECT_FALSE(view->perspective);
  EXPECT_NEAR(view->focal, 2, 1e-5);
}

// In the picture is what the planes let through, under all transforms, also where near and far lie far apart.
TEST(TeCameraView, PlanesBoundWhatIsSeen) {
  std::mt19937 numbers(5);
  std::uniform_real_distribution<float> number(-1, 1);
  int inside = 0;
  for (int i = 0; i < 200; i++) {
    SbMatrix model;
    model.setTransform(SbVec3f(number(numbers), number(numbers), number(numbers)) * 50,
                       SbRotation(SbVec3f(number(numbers), number(numbers), 1), number(numbers) * 3),
                       SbVec3f(1 + 0.5f * number(numbers), 2, 0.5f));
    const SbViewVolume volume = perspective(20 + 15 * (i % 10), SbVec3f(10, 20, 30) * number(numbers), 0.1f,
                                            i % 2 == 0 ? 500.0f : 1e6f);
    const auto view = TeCameraView::create(volume, kPixels, model);
    ASSERT_TRUE(view);
    ASSERT_EQ(view->planeCount, 6);
    SbMatrix clip = model;
    clip.multRight(volume.getMatrix());
    for (int j = 0; j < 100; j++) {
      const glm::dvec3 point = random(numbers, 200);
      SbVec4f seen;
      clip.multVecMatrix(SbVec4f(float(point.x), float(point.y), float(point.z), 1), seen);
      double margin = std::numeric_limits<double>::max();
      for (int axis = 0; axis < 3; axis++)
        margin = std::min<double>(margin, seen[3] - std::abs(seen[axis]));
      const double size = std::abs(seen[3]) + 1;
      if (margin > 1e-4 * size) {
        inside++;
        EXPECT_TRUE(view->meets(point, point));
      } else if (margin < -1e-2 * size) {
        EXPECT_FALSE(view->meets(point, point));
      }
    }
  }
  EXPECT_GT(inside, 500);
}

TEST(TeCameraView, ScreenErrorsHoldUnderAnyTransform) {
  std::mt19937 numbers(6);
  std::uniform_real_distribution<float> number(0.2f, 3);
  double worst = 0;
  for (int i = 0; i < 500; i++) {
    SbMatrix model;
    model.setTransform(
        SbVec3f(1, 2, 3) * number(numbers), SbRotation(SbVec3f(number(numbers), 1, 0), number(numbers)),
        SbVec3f(number(numbers), number(numbers), number(numbers)), SbRotation(SbVec3f(1, 1, 1), 1));
    const SbViewVolume volume = perspective(45, SbVec3f(5, -3, 8) * number(numbers));
    const auto view = TeCameraView::create(volume, kPixels, model);
    ASSERT_TRUE(view);
    const double focal = 768 / 2.0 / std::tan(45 * kPi / 360);
    for (int j = 0; j < 20; j++) {
      const glm::dvec3 at = random(numbers, 20);
      SbVec3f point, raised;
      model.multVecMatrix(SbVec3f(float(at.x), float(at.y), float(at.z)), point);
      model.multVecMatrix(SbVec3f(float(at.x), float(at.y), float(at.z) + 1), raised);
      const double drawn = focal * (raised - point).length() / (point - volume.getProjectionPoint()).length();
      const double stated = view->pixels(1, glm::length(at - view->eye));
      EXPECT_LE(drawn, stated * (1 + 1e-4));
      worst = std::max(worst, drawn / stated);
    }
  }
  EXPECT_GT(worst, 0.9); // and there are directions in which no less would do
}

TEST(TeCameraView, ScalingEverythingAlikeChangesNoScreenError) {
  SbMatrix model;
  model.setTransform(SbVec3f(4, 5, 6), SbRotation(SbVec3f(1, 2, 3), 2), SbVec3f(20, 20, 20));
  const auto plain = TeCameraView::create(perspective(60), kPixels, SbMatrix::identity());
  const auto scaled = TeCameraView::create(perspective(60), kPixels, model);
  ASSERT_TRUE(plain && scaled);
  EXPECT_NEAR(scaled->focal / plain->focal, 1, 1e-5);
}

TEST(TeCameraView, NoViewOfWhatIsFlattenedOrNotFinite) {
  SbMatrix flat;
  flat.setScale(SbVec3f(1, 1, 0));
  EXPECT_FALSE(TeCameraView::create(perspective(60), kPixels, flat));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(TeCameraView::create(perspective(60, SbVec3f(nan, 0, 0)), kPixels, SbMatrix::identity()));
  EXPECT_FALSE(TeCameraView::create(perspective(60), SbVec2s(0, 0), SbMatrix::identity()));
  SbMatrix broken = SbMatrix::identity();
  broken[1][2] = nan;
  EXPECT_FALSE(TeCameraView::create(perspective(60), kPixels, broken));
}

TEST(TeCameraView, IsThatOfTheCameraTraversed) {
  const auto scene = readScene("PerspectiveCamera { position 7 8 109 heightAngle 1.0471976 }\n"
                               "Translation { translation 0 0 100 }\n"
                               "DEF TestHere Callback {}");
  ASSERT_TRUE(scene);
  SoCallbackAction action(SbViewportRegion(1024, 768));
  int looks = 0;
  inState(scene.get(), action, [&](SoState* state) {
    looks++;
    EXPECT_TRUE(TeCameraView::hasCamera(state));
    const auto view = TeCameraView::fromState(state);
    ASSERT_TRUE(view);
    EXPECT_NEAR(view->focal, 665.1, 0.05);
    EXPECT_NEAR(glm::length(view->eye - glm::dvec3(7, 8, 9)), 0, 1e-5);
    TeNodePtr<SoPerspectiveCamera> other(new SoPerspectiveCamera);
    other->position.setValue(1, 2, 3);
    const auto from = TeCameraView::fromCamera(*other, state);
    ASSERT_TRUE(from);
    EXPECT_NEAR(glm::length(from->eye - glm::dvec3(1, 2, -97)), 0, 1e-5);
  });
  EXPECT_EQ(looks, 1);
}

TEST(TeCameraView, ACameraSeesTheSameWithoutBeingTraversed) {
  const auto scene = readScene("DEF TestEye PerspectiveCamera { position 7 8 109 heightAngle 0.9 }\n"
                               "DEF TestHere Callback {}");
  ASSERT_TRUE(scene);
  const auto* camera = static_cast<SoCamera*>(SoNode::getByName("TestEye"));
  ASSERT_TRUE(camera);
  for (const SbVec2s& pixels : {SbVec2s(320, 240), SbVec2s(300, 300), SbVec2s(200, 500)}) {
    SoCallbackAction action{SbViewportRegion(pixels)};
    inState(scene.get(), action, [&](SoState* state) {
      const auto traversed = TeCameraView::fromState(state);
      const auto other = TeCameraView::fromCamera(*camera, state);
      ASSERT_TRUE(traversed && other);
      EXPECT_NEAR(other->focal, traversed->focal, 1e-6 * traversed->focal) << pixels[0];
      for (std::size_t i = 0; i < 6; i++)
        EXPECT_LT(glm::length(other->planes[i] - traversed->planes[i]), 1e-5) << pixels[0] << " " << i;
    });
  }
}

TEST(TeCameraView, KnowsWhetherThereIsACamera) {
  const auto scene = readScene("DEF TestHere Callback {}");
  ASSERT_TRUE(scene);
  int looks = 0;
  SoCallbackAction action;
  SoGetPrimitiveCountAction count;
  for (SoAction* each : {static_cast<SoAction*>(&action), static_cast<SoAction*>(&count)})
    inState(scene.get(), *each, [&](SoState* state) {
      looks++;
      EXPECT_FALSE(TeCameraView::hasCamera(state));
    });
  EXPECT_EQ(looks, 2);
}

// Terrain in degrees, or piled up a thousand times and more: the deviation may be up, the distance across.
TEST(TeCameraView, FocalIsRightUnderUnequalScales) {
  const double plain = TeCameraView::create(perspective(60), kPixels, SbMatrix::identity())->focal;
  for (const float scale : {0.1f, 1e-3f, 1e-4f, 1e-5f, 1e-6f, 10.0f, 1e5f}) {
    SbMatrix model;
    model.setTransform(SbVec3f(1, 2, 3), SbRotation(SbVec3f(1, 2, 3), 0.7f), SbVec3f(scale, scale, 1));
    const auto view = TeCameraView::create(perspective(60), kPixels, model);
    ASSERT_TRUE(view) << scale;
    EXPECT_NEAR(view->focal / plain * std::min(1.0, double(scale)), 1, 0.05) << scale;
  }
}
