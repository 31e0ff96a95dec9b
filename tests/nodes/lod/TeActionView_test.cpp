#include "nodes/lod/TeActionView.h"

#include <Inventor/SbLine.h>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <random>

TEST(TeActionView, FromAboveSeesTheWholeSquare) {
  const TeLodView view = TeActionView::fromAbove({100, 200, 5}, 64, 30);
  EXPECT_EQ(view.eye, glm::dvec3(132, 232, 94));
  EXPECT_EQ(view.planeCount, 0);
  EXPECT_TRUE(view.perspective);
}

TEST(TeActionView, AlongALineOnlyItsBoxesAreSeen) {
  std::mt19937 numbers(5);
  std::uniform_real_distribution<double> number(-1, 1);
  TeLodView view = TeActionView::fromAbove({0, 0, 0}, 100, 10);
  const TeLodView whole = view;
  for (int i = 0; i < 200; i++) {
    const glm::dvec3 from(100 * number(numbers), 100 * number(numbers), 100 * number(numbers));
    const glm::dvec3 along = glm::normalize(glm::dvec3(number(numbers), number(numbers), number(numbers)));
    const SbVec3f start{float(from.x), float(from.y), float(from.z)};
    TeActionView::seeOnly(SbLine(start, start + SbVec3f(float(along.x), float(along.y), float(along.z))), 100,
                          view);
    EXPECT_EQ(view.eye, whole.eye);
    EXPECT_EQ(view.focal, whole.focal);
    const glm::dvec3 ahead = from + 40.0 * along, behind = from - 40.0 * along;
    EXPECT_TRUE(view.meets(ahead - 0.01, ahead + 0.01));
    EXPECT_FALSE(view.meets(behind - 0.01, behind + 0.01));
    const glm::dvec3 beside = ahead + 3.0 * glm::normalize(glm::cross(along, glm::dvec3(0.3, 0.4, 0.5)));
    EXPECT_FALSE(view.meets(beside - 0.5, beside + 0.5));
  }
}
