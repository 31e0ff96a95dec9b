#include "nodes/clipmap/TeSampleRect.h"

#include <gtest/gtest.h>

TEST(TeSampleRect, IntersectionHasTheSamplesOfBoth) {
  const TeSampleRect rects[] = {{0, 0, 4, 3},   {2, 1, 5, 5}, {4, 0, 2, 2},
                                {-3, -1, 4, 3}, {1, 1, 0, 4}, {9, 9, 1, 1}};
  for (const TeSampleRect& a : rects)
    for (const TeSampleRect& b : rects) {
      const TeSampleRect both = teIntersection(a, b);
      int samples = 0;
      for (int y = -5; y < 15; y++)
        for (int x = -5; x < 15; x++) {
          const bool isInBoth = a.holds(x, y) && b.holds(x, y);
          samples += isInBoth;
          EXPECT_EQ(both.holds(x, y), isInBoth);
        }
      EXPECT_EQ(both.count(), samples);
      EXPECT_EQ(both.isEmpty(), samples == 0);
      EXPECT_EQ(teIntersection(a, a).count(), a.count());
    }
}
