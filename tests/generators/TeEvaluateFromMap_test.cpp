#include "generators/TeEvaluateFromMap.h"

#include "generators/midpoint/TeMidpointGenerator.h"

#include <gtest/gtest.h>

// Any source will do, also one that has no way of its own to single samples.
TEST(TeEvaluateFromMap, GivesTheMapsSamplesInTheOrderAskedFor) {
  TeMidpointGenerator generator;
  ASSERT_TRUE(generator.updateParams());
  const TeMapRequest request = *TeMapRequest::standalone(17, 17, 1, 5);
  const TeHeightMap map = *generator.source()->generate(request);
  const TeMapSample samples[] = {{16, 16}, {0, 3}, {5, 0}, {5, 0}};
  float heights[4];
  ASSERT_TRUE(teEvaluateFromMap(*generator.source(), request, samples, 4, heights));
  for (int i = 0; i < 4; ++i)
    EXPECT_EQ(heights[i], map.at(samples[i].column, samples[i].row));
}

TEST(TeEvaluateFromMap, PassesTheMapsErrorOn) {
  TeMidpointGenerator generator;
  ASSERT_TRUE(generator.updateParams());
  const TeMapRequest request = *TeMapRequest::standalone(18, 17, 1, 5); // no size for midpoint displacement
  const TeMapSample sample = {0, 0};
  float height;
  EXPECT_FALSE(teEvaluateFromMap(*generator.source(), request, &sample, 1, &height));
}
