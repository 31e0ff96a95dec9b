#include "engine/jobs/TeUrgency.h"

#include <gtest/gtest.h>

#include <vector>

namespace {

TEST(TeUrgency, RankThenDistanceThenKeyThenPart) {
  const std::vector<TeUrgency> ordered = {{0, 1, {0, 0, 0}, 0}, {0, 2, {-5, -5, 0}, 0}, {1, 0, {0, 0, 0}, 0},
                                          {1, 0, {0, 0, 0}, 1}, {1, 0, {1, 0, 0}, 0},   {1, 0, {-1, 1, 0}, 0},
                                          {2, -1, {0, 0, 0}, 0}};
  for (std::size_t i = 0; i < ordered.size(); ++i)
    for (std::size_t j = 0; j < ordered.size(); ++j)
      EXPECT_EQ(ordered[i] < ordered[j], i < j) << i << " " << j;
}

} // namespace
