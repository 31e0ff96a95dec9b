#include "nodes/lod/TePerspectiveView.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>

namespace {

TePerspectiveView slanted() {
  TePerspectiveView view;
  view.eye = {1000, -2000, 300};
  view.forward = glm::normalize(glm::dvec3(1, 2, -0.3));
  view.nearDistance = 10;
  view.farDistance = 5000;
  return view;
}

bool sees(const TePerspectiveView& view, double right, double up, double ahead) {
  const glm::dvec3 point = view.eye + right * view.right() + up * view.up() + ahead * view.forward;
  return view.lodView().meets(point, point);
}

TEST(TePerspectiveView, AxesAreALevelRightHandedFrame) {
  const TePerspectiveView view = slanted();
  EXPECT_NEAR(view.right().z, 0, 1e-15);
  EXPECT_GT(view.up().z, 0);
  EXPECT_NEAR(glm::length(view.right()), 1, 1e-15);
  EXPECT_NEAR(glm::length(view.up()), 1, 1e-15);
  EXPECT_NEAR(glm::dot(view.right(), view.forward), 0, 1e-15);
  EXPECT_NEAR(glm::dot(glm::cross(view.right(), view.up()), -view.forward), 1, 1e-15);
}

TEST(TePerspectiveView, AMetreAtOneMetreHasFocalPixels) {
  TePerspectiveView view = slanted();
  EXPECT_NEAR(view.lodView().focal, 665.1, 0.05);
  EXPECT_NEAR(view.lodView().pixels(2, 665.1), 2, 1e-3);
  view.height = 1536;
  EXPECT_NEAR(view.lodView().focal, 2 * 665.1, 0.1);
}

TEST(TePerspectiveView, PlanesBoundTheViewport) {
  const TePerspectiveView view = slanted();
  const double up = 1000 * std::tan(0.5 * view.fieldOfView);
  const double right = up * view.width / view.height;
  for (const double side : {-1.0, 1.0}) {
    EXPECT_TRUE(sees(view, side * right * 0.999, 0, 1000));
    EXPECT_FALSE(sees(view, side * right * 1.001, 0, 1000));
    EXPECT_TRUE(sees(view, 0, side * up * 0.999, 1000));
    EXPECT_FALSE(sees(view, 0, side * up * 1.001, 1000));
  }
  EXPECT_TRUE(sees(view, 0, 0, 10.01));
  EXPECT_FALSE(sees(view, 0, 0, 9.99));
  EXPECT_TRUE(sees(view, 0, 0, 4999));
  EXPECT_FALSE(sees(view, 0, 0, 5001));
  EXPECT_FALSE(sees(view, 0, 0, -100));
}

} // namespace
