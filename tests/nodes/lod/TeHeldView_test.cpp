#include "nodes/lod/TeHeldView.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <random>

namespace {

TeLodView viewFrom(const glm::dvec3& eye) {
  TeLodView view;
  view.eye = eye;
  view.focal = 700;
  return view;
}

} // namespace

TEST(TeHeldView, TheSameViewIsTakenOverOnce) {
  TeHeldView held;
  EXPECT_TRUE(held.update(viewFrom({1, 2, 3}), 0.5));
  EXPECT_EQ(held.view().eye, glm::dvec3(1, 2, 3));
  EXPECT_EQ(held.view().slack, 0.5);
  EXPECT_FALSE(held.update(viewFrom({1, 2, 3}), 0.5));
  held.release();
  EXPECT_TRUE(held.update(viewFrom({1, 2, 3}), 0.5));
}

TEST(TeHeldView, TheEyeStaysWithinTheRadius) {
  TeHeldView held;
  held.update(viewFrom({0, 0, 0}), 2);
  EXPECT_FALSE(held.update(viewFrom({0, 1.9, 0}), 2));
  EXPECT_FALSE(held.update(viewFrom({0, 0, -2}), 2));
  EXPECT_EQ(held.view().eye, glm::dvec3(0));
  EXPECT_TRUE(held.update(viewFrom({1.5, 1.5, 0}), 2));
  EXPECT_EQ(held.view().eye, glm::dvec3(1.5, 1.5, 0));
  // Not from where it was before.
  EXPECT_TRUE(held.update(viewFrom({0, 0, 0}), 2));
}

TEST(TeHeldView, HeldDoesNotTakeOver) {
  TeHeldView held;
  held.update(viewFrom({0, 0, 0}), 2);
  EXPECT_EQ(held.held(viewFrom({1, 0, 0}), 2).eye, glm::dvec3(0));
  EXPECT_EQ(held.held(viewFrom({9, 0, 0}), 2).eye, glm::dvec3(9, 0, 0));
  EXPECT_EQ(held.view().eye, glm::dvec3(0));
}

TEST(TeHeldView, WhatIsInViewIsAlwaysTrue) {
  TeHeldView held;
  TeLodView view = viewFrom({0, 0, 0});
  view.planeCount = 1;
  view.planes[0] = {1, 0, 0, 5};
  held.update(view, 2);
  view.eye.x = 1;
  view.planes[0].w = 4;
  EXPECT_TRUE(held.update(view, 2));
  EXPECT_EQ(held.view().eye, glm::dvec3(0));
  EXPECT_EQ(held.view().planes[0].w, 4);
  view.focal = 701;
  EXPECT_TRUE(held.update(view, 2));
}

TEST(TeHeldView, NothingIsHeldWithoutARadiusOrPerspective) {
  TeHeldView held;
  held.update(viewFrom({0, 0, 0}), 2);
  EXPECT_TRUE(held.update(viewFrom({0, 0, 1e-9}), 0));
  EXPECT_EQ(held.view().eye.z, 1e-9);
  EXPECT_EQ(held.view().slack, 0);
  TeLodView flat = viewFrom({0, 0, 0});
  flat.perspective = false;
  EXPECT_TRUE(held.update(flat, 2));
  EXPECT_EQ(held.view().slack, 0);
  flat.eye.x = 0.1;
  EXPECT_TRUE(held.update(flat, 2));
}

// The law that bounds rest on: no true eye is nearer to anything than the held one less its slack.
TEST(TeHeldView, SlackCoversEveryTrueEye) {
  std::mt19937 numbers(4);
  std::uniform_real_distribution<double> number(-3, 3);
  TeHeldView held;
  glm::dvec3 eye(0);
  int taken = 0;
  for (int i = 0; i < 5000; i++) {
    eye += glm::dvec3(number(numbers), number(numbers), number(numbers)) * 0.3;
    taken += held.update(viewFrom(eye), 1.5);
    const glm::dvec3 point(number(numbers) * 9, number(numbers) * 9, number(numbers) * 9);
    EXPECT_GE(glm::length(point - eye), glm::length(point - held.view().eye) - held.view().slack - 1e-12);
  }
  EXPECT_GT(taken, 10);
  EXPECT_LT(taken, 4000);
}
