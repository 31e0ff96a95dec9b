#include "nodes/lod/TeLodView.h"

#include "generators/base/TeRandom.h"
#include "nodes/lod/TePerspectiveView.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <limits>

TEST(TeLodView, PixelsFallWithTheDistance) {
  TeLodView view;
  view.focal = 600;
  EXPECT_DOUBLE_EQ(view.pixels(2, 300), 4);
  EXPECT_DOUBLE_EQ(view.pixels(2, 600), 2);
  EXPECT_EQ(view.pixels(2, 0), std::numeric_limits<double>::infinity());
  EXPECT_EQ(view.pixels(0, 0), 0);
}

TEST(TeLodView, PixelsOfAnOrthographicViewDoNot) {
  TeLodView view;
  view.perspective = false;
  view.focal = 3;
  EXPECT_DOUBLE_EQ(view.pixels(2, 0), 6);
  EXPECT_DOUBLE_EQ(view.pixels(2, 1e9), 6);
  EXPECT_EQ(view.pixels(0, 5), 0);
}

TEST(TeLodView, WithoutPlanesEverythingIsSeen) { EXPECT_TRUE(TeLodView().meets({-1e9, 5, 5}, {-1e9, 5, 5})); }

// A box is met if any point of it is seen, whatever its size; boxes wholly behind a plane are not.
TEST(TeLodView, BoxesWithAPointInViewAreMet) {
  TePerspectiveView camera;
  camera.forward = glm::normalize(glm::dvec3(1, 1, -0.2));
  const TeLodView view = camera.lodView();
  TeRandom random(5, 0, TeMapKey{});
  int met = 0, missed = 0;
  for (int trial = 0; trial < 20000; trial++) {
    const double size = random.below(2) ? 10 : 20000;
    const auto corner = [&] {
      return glm::dvec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    };
    const glm::dvec3 centre = corner() * 20000.0, half = glm::abs(corner()) * size;
    const glm::dvec3 inside = centre + corner() * half;
    const bool boxMet = view.meets(centre - half, centre + half);
    const bool pointMet = view.meets(inside, inside);
    EXPECT_TRUE(boxMet || !pointMet);
    met += pointMet;
    missed += !boxMet;
    bool behind = false;
    for (int i = 0; i < view.planeCount; i++) {
      double most = -std::numeric_limits<double>::infinity();
      for (int k = 0; k < 8; k++) {
        const glm::dvec3 sign(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
        const glm::dvec4& plane = view.planes[std::size_t(i)];
        most = std::max(most, glm::dot(glm::dvec3(plane), centre + sign * half) + plane.w);
      }
      behind = behind || most < -1e-6;
    }
    if (behind) {
      EXPECT_FALSE(boxMet);
    }
  }
  EXPECT_GT(met, 500);
  EXPECT_GT(missed, 5000);
}
