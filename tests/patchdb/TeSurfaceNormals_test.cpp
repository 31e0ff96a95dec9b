#include "patchdb/TeSurfaceNormals.h"

#include "generators/TeHeightMap.h"
#include "generators/base/TeRandom.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

TEST(TeSurfaceNormals, FlatGroundIsExactlyUp) {
  for (float height : {0.0f, -0.0f, 1234.5f, -1e30f})
    for (double spacing : {1e-6, 0.1, 1.0, 30.0, 1e6})
      EXPECT_EQ(teSampleNormal(height, height, height, height, height, spacing), glm::vec3(0, 0, 1));
}

TEST(TeSurfaceNormals, SlopesAreThoseOfThePlane) {
  const glm::vec3 normal = teSampleNormal(0, -3, 3, 0, 0, 3); // rises 1 to the east
  EXPECT_FLOAT_EQ(normal.x, -std::sqrt(0.5f));
  EXPECT_EQ(normal.y, 0);
  EXPECT_FLOAT_EQ(normal.z, std::sqrt(0.5f));
  const glm::vec3 north = teSampleNormal(0, 0, 0, 3, -3, 3); // falls 1 to the north
  EXPECT_FLOAT_EQ(north.y, std::sqrt(0.5f));
}

TEST(TeSurfaceNormals, MissingNeighboursLeaveTheOtherSide) {
  const float hole = TeHeightMap::missing();
  const glm::vec3 plane = teSampleNormal(10, 9, 11, 8, 12, 1);
  EXPECT_EQ(teSampleNormal(10, hole, 11, 8, 12, 1), plane);
  EXPECT_EQ(teSampleNormal(10, 9, hole, 8, hole, 1), plane);
  EXPECT_EQ(teSampleNormal(10, hole, hole, 8, 12, 1), teSampleNormal(10, 10, 10, 8, 12, 1));
  EXPECT_EQ(teSampleNormal(10, hole, hole, hole, hole, 1), glm::vec3(0, 0, 1));
  EXPECT_EQ(teSampleNormal(hole, 9, 11, 8, 12, 1), glm::vec3(0, 0, 1));
}

TEST(TeSurfaceNormals, BlocksHaveTheBitsOfSingleSamples) {
  TeRandom random(8, 1, {});
  for (int side : {3, 5, 19, 33}) {
    std::vector<float> heights(std::size_t(side) * side);
    for (float& height : heights)
      height = float(random.uniform(-500, 500));
    for (bool missing : {false, true}) {
      if (missing)
        for (int i = 0; i < side; ++i)
          heights[random.below(heights.size())] = TeHeightMap::missing();
      const int inner = side - 2;
      std::vector<glm::vec3> normals(std::size_t(inner) * inner);
      teGridNormals(heights.data() + side + 1, side, inner, inner, 0.7, missing, normals.data());
      for (int y = 0; y < inner; ++y)
        for (int x = 0; x < inner; ++x) {
          const float* h = heights.data() + (y + 1) * side + x + 1;
          ASSERT_EQ(normals[std::size_t(y * inner + x)],
                    teSampleNormal(h[0], h[-1], h[1], h[-side], h[side], 0.7));
        }
    }
  }
}
