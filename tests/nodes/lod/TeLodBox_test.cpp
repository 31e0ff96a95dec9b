#include "nodes/lod/TeLodBox.h"
#include "tests/nodes/lod/lodTrials.h"

// Down a tree of boxes, with ever fewer planes, exactly what TeLodView::meets() sees is seen.
TEST(TeLodBox, isSeenAsTheViewSeesIt) {
  std::mt19937 random(3);
  const TeLodFieldPtr field = anyField(StressField::Rough, 64, random);
  int seen = 0, free = 0;
  for (int camera = 0; camera < 500; camera++) {
    const TeLodView view = anyView(*field, camera % 10 == 0, random);
    int x = 0, y = 0;
    unsigned planes = TeLodBox::allPlanes(view);
    for (int cells = 64; cells > 0; cells /= 2) {
      const TeLodBox box{field->position(x, y, double(field->lowest())),
                         field->position(x + cells, y + cells, double(field->highest()))};
      const bool meets = view.meets(box.low, box.high);
      ASSERT_EQ(box.isSeen(view, planes), meets) << camera << " " << cells;
      if (!meets)
        break;
      seen++;
      free += planes == 0;
      x += int(random() % 2) * cells / 2;
      y += int(random() % 2) * cells / 2;
    }
  }
  EXPECT_GT(seen, 500);
  EXPECT_GT(free, 100);
}

TEST(TeLodBox, distanceIsThatOfItsNearestPoint) {
  const TeLodBox box{{0, 0, 0}, {10, 20, 5}};
  EXPECT_EQ(box.distance(viewFrom({5, 5, 5})), 0);
  EXPECT_EQ(box.distance(viewFrom({5, 5, 12})), 7);
  EXPECT_EQ(box.distance(viewFrom({13, 24, 2})), 5);
  TeLodView trembling = viewFrom({5, 5, 12});
  trembling.slack = 3;
  EXPECT_EQ(box.distance(trembling), 4);
  trembling.slack = 30;
  EXPECT_EQ(box.distance(trembling), 0);
}

// What is found is never too much, and next to nothing is lost.
TEST(TeLodBox, largestDeviationShowsAsWanted) {
  std::mt19937 random(4);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int trial = 0; trial < 10000; trial++) {
    TeLodView view;
    view.focal = std::exp(uniform(-3, 9));
    view.perspective = random() % 4 != 0;
    const double wanted = std::exp(uniform(-4, 6)), distance = std::exp(uniform(-2, 12));
    const double scale = std::exp(uniform(-5, 3));
    const double deviation = teLargestDeviation(view, wanted, distance, scale);
    const double pixels = view.pixels(deviation * scale, distance);
    ASSERT_LE(pixels, wanted);
    ASSERT_GT(pixels, wanted * (1 - 1e-12));
  }
  EXPECT_TRUE(std::isinf(teLargestDeviation(TeLodView(), 1, 100, 0)));
  EXPECT_EQ(teLargestDeviation(TeLodView(), 1, 0, 1), 0);
}
