#include "nodes/TeCoinVectors.h"

#include <gtest/gtest.h>

TEST(TeCoinVectors, KeepAllDigitsThatTheyCanHave) {
  EXPECT_EQ(teToGlm(SbVec3d(1e9 + 0.125, -2, 3e-300)), glm::dvec3(1e9 + 0.125, -2, 3e-300));
  EXPECT_EQ(teToGlm(SbVec3f(0.1f, -2, 3e-30f)), glm::dvec3(0.1f, -2, 3e-30f));
  EXPECT_EQ(teToCoin(glm::dvec3(0.1, -2, 3e-30)), SbVec3f(0.1f, -2, 3e-30f));
}
