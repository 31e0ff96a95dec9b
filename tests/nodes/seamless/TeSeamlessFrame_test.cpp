#include "nodes/seamless/TeSeamlessFrame.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

glm::dmat4 viewFrom(const glm::dvec3& eye, const glm::dvec3& at) { return glm::lookAt(eye, at, {0, 0, 1}); }

const glm::dmat4 kProjection = glm::perspective(0.8, 4.0 / 3, 1.0, 1e5);

TeSeamlessPlacement placementAt(const glm::dvec3& corner) {
  TeSeamlessPlacement placement;
  placement.corner = corner;
  placement.spacing = 10;
  placement.heightScale = 0.1;
  return placement;
}

} // namespace

TEST(TeSeamlessFrame, FindsTheEyeAndPutsSamplesAroundIt) {
  const glm::dvec3 eye(1234.5, -777.25, 321.75);
  const TeSeamlessFrame frame(placementAt({-500, -900, 20}), viewFrom(eye, {2000, 500, 0}), kProjection);
  ASSERT_TRUE(frame.isValid());
  EXPECT_LT(glm::distance(frame.eye(), eye), 1e-9);
  const glm::dvec3 sample = glm::dvec3(-500 + 77 * 10, -900 + 5 * 10, 20 + 0.1 * 4321);
  EXPECT_LT(glm::distance(glm::dvec3(frame.relative(77, 5, 4321)), sample - eye), 1e-4);
}

TEST(TeSeamlessFrame, MatricesTakeRelativePositionsWhereTheSceneHasThem) {
  const glm::dvec3 eye(100, 200, 300);
  glm::dmat4 view = viewFrom(eye, {900, 800, 0});
  view = view * glm::scale(glm::dmat4(1), {2, 2, 3}); // a model matrix; the eye is then elsewhere
  const TeSeamlessFrame frame(placementAt({0, 0, 0}), view, kProjection);
  const glm::dvec4 whole = kProjection * view * glm::dvec4(400, 500, 2, 1);
  const glm::dvec4 clip(frame.clipFromRelative() * glm::vec4(frame.relative(40, 50, 20), 1));
  EXPECT_LT(glm::distance(whole, clip), 1e-3 * glm::length(whole));
}

// Contract 4: nothing depends on the distance from any origin.
TEST(TeSeamlessFrame, TheSameSceneFarAwayHasTheSameBits) {
  const glm::dvec3 eye(1000, 2000, 512);
  const TeSeamlessFrame near(placementAt({0, 0, 0}), viewFrom(eye, eye + glm::dvec3(100, 50, -30)),
                             kProjection);
  for (const double away : {1e5, 1e7, 1e9}) {
    const glm::dvec3 offset(std::floor(away / 4096) * 4096, -std::floor(away / 4096) * 4096, 1024);
    const glm::dvec3 moved = eye + offset;
    const TeSeamlessFrame far(placementAt(offset), viewFrom(moved, moved + glm::dvec3(100, 50, -30)),
                              kProjection);
    EXPECT_LT(glm::distance(near.relative(123, 321, 100), far.relative(123, 321, 100)), away * 1e-12);
    EXPECT_LT(glm::distance(near.clipFromRelative()[0], far.clipFromRelative()[0]), 1e-6f);
  }
}

TEST(TeSeamlessFrame, AnEyeFarBeyondAllSamplesIsStillRight) {
  const glm::dvec3 eye(1e12, 5, 1);
  const TeSeamlessFrame frame(placementAt({0, 0, 0}), viewFrom(eye, {0, 0, 0}), kProjection);
  ASSERT_TRUE(frame.isValid());
  EXPECT_NEAR(frame.relative(3, 0, 0).x / -1e12, 1, 1e-6);
}

TEST(TeSeamlessFrame, ViewsThatShowNothingAreNotValid) {
  const double infinite = std::numeric_limits<double>::infinity();
  glm::dmat4 flat(1);
  flat[2][2] = 0;
  EXPECT_FALSE(TeSeamlessFrame(placementAt({0, 0, 0}), flat, kProjection).isValid());
  glm::dmat4 broken(1);
  broken[3][0] = infinite;
  EXPECT_FALSE(TeSeamlessFrame(placementAt({0, 0, 0}), broken, kProjection).isValid());
  EXPECT_FALSE(TeSeamlessFrame(placementAt({0, 0, 0}), glm::dmat4(1), kProjection * infinite).isValid());
  TeSeamlessPlacement placement = placementAt({0, 0, 0});
  placement.spacing = 0;
  EXPECT_FALSE(TeSeamlessFrame(placement, glm::dmat4(1), kProjection).isValid());
}
