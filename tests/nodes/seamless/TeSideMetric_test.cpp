#include "nodes/seamless/TeSideMetric.h"

#include "nodes/seamless/SeamlessViews.h"

#include <gtest/gtest.h>

namespace {

const TeSeamlessLayout kLayout = TeSeamlessLayout::create(1024, 16, 3).value();

TeSideMetric byPrecision(const TeLodView& view, double precision, bool geomorph = false) {
  TeSeamlessAccuracy accuracy;
  accuracy.precision = precision;
  accuracy.geomorph = geomorph;
  return TeSideMetric(kLayout, nullptr, TeSeamlessPlacement(), view, accuracy, 1);
}

float detailOf(const TeSideMetric& metric, const TeSideKey& side) { return metric.detail(metric.see(side)); }

} // namespace

// Document 004, equation 5.3: e = p·l / d; divided above 1, else e times the highest resolution, rounded up.
TEST(TeSideMetric, isTheDocuments) {
  const TeSideKey side{0, true, 0, 0}; // 1024 long
  const auto at = [&](double distance, double precision) {
    return byPrecision(viewFrom({500, -distance, 0}), precision);
  };
  const auto detailAt = [&](double distance, double precision) {
    return detailOf(at(distance, precision), side);
  };
  EXPECT_NEAR(at(4096, 2).division(0, 0, 0), 0.5, 1e-12);
  EXPECT_GT(at(1000, 1).division(0, 0, 0), at(1000, 1).threshold(0));
  EXPECT_LT(at(1030, 1).division(0, 0, 0), at(1030, 1).threshold(0));
  EXPECT_EQ(detailAt(1100, 1), 2) << "e = 0.93: 64";
  EXPECT_EQ(detailAt(2100, 1), 1) << "e = 0.49: 32";
  EXPECT_EQ(detailAt(4200, 1), 0) << "e = 0.24: 16";
  EXPECT_EQ(detailAt(1e6, 1), 0) << "never less";
  EXPECT_EQ(detailAt(4200, 2), 1);
}

TEST(TeSideMetric, morphsFromOneResolutionToTheNext) {
  const TeSideKey side{0, true, 0, 0};
  float last = 2;
  for (double distance = 1025; distance < 5000; distance *= 1.01) {
    const float detail = detailOf(byPrecision(viewFrom({500, -distance, 0}), 1, true), side);
    EXPECT_LE(detail, last);
    EXPECT_LT(last - detail, 0.02f);
    last = detail;
  }
  EXPECT_EQ(last, 0);
}

TEST(TeSideMetric, tellsThePrecisionThatWouldDrawTheSame) {
  const TeSideKey side{0, true, 0, 0};
  for (const double distance : {1100.0, 2100.0, 4200.0}) {
    const TeLodView view = viewFrom({500, -distance, 0});
    const TeSideMetric metric = byPrecision(view, 1);
    const int index = int(detailOf(metric, side));
    const double precision = std::sqrt(metric.squaredPrecision(metric.see(side), index));
    EXPECT_GE(precision, 1);
    EXPECT_EQ(detailOf(byPrecision(view, precision * 0.999), side), index);
  }
}

TEST(TeSideMetric, errorsFallWithDistanceAndRiseWithTheFocalLength) {
  std::mt19937 random(1);
  const TeHeightMap map = stressMap(StressField::Rough, 1024, random);
  const auto bounds = TeSeamlessBounds::create(kLayout, map).value();
  TeSeamlessAccuracy accuracy;
  accuracy.pixelError = 1;
  const TeSideKey side{1, false, 1, 1};
  double last = std::numeric_limits<double>::infinity();
  for (double distance = 200; distance < 1e5; distance *= 2) {
    const TeSideMetric near(kLayout, bounds.get(), TeSeamlessPlacement(), viewFrom({500, -distance, 30}),
                            accuracy, 1);
    const TeSideMetric zoomed(kLayout, bounds.get(), TeSeamlessPlacement(),
                              viewFrom({500, -distance, 30}, 6651), accuracy, 1);
    const auto error = [&](int index) { return near.errorPixels(near.see(side), index); };
    EXPECT_LT(error(0), last);
    EXPECT_NEAR(zoomed.errorPixels(zoomed.see(side), 0), 10 * error(0), 1e-9 * error(0));
    EXPECT_GE(error(0), error(1));
    last = error(0);
    // What it asks for is enough.
    const int index = int(detailOf(near, side));
    if (index < 2) {
      EXPECT_LE(error(index), 1);
    }
  }
}

// An eye that may be nearer by the slack sees errors as large as there.
TEST(TeSideMetric, slackCountsAsDistance) {
  std::mt19937 random(1);
  const auto bounds =
      TeSeamlessBounds::create(kLayout, stressMap(StressField::Checkerboard, 1024, random)).value();
  TeSeamlessAccuracy accuracy;
  accuracy.pixelError = 1;
  const TeSideKey side{0, true, 0, 0};
  TeLodView held = viewFrom({500, -1000, 2});
  held.slack = 100;
  const TeLodView moved = viewFrom({500, -900, 2});
  const auto error = [&](const TeLodView& view) {
    const TeSideMetric metric(kLayout, bounds.get(), TeSeamlessPlacement(), view, accuracy, 1);
    return metric.errorPixels(metric.see(side), 0);
  };
  EXPECT_NEAR(error(held), error(moved), 1e-9);
}
