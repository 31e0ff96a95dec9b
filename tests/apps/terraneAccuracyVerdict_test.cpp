// The words of terrane-accuracy lod, on tables whose truth is known.

#include "apps/terrane-accuracy/TeLodVerdict.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

struct Law {
  std::string method;
  double triangles, select, frame; ///< at 1 px
  double power;                    ///< all cost error^-power
  double uploads = 1000;
};

TeTable emptyTable() {
  return TeTable({"method", "wanted_px", "dial", "triangles", "select_ms", "upload_bytes", "frame_ms",
                  "worst_px", "uncovered", "cracks", "overshoots", "draw_calls", "layout", "bytes_per_sample",
                  "bound_px"});
}

void add(TeTable& table, const Law& law, double wanted, std::int64_t overshoots = 0) {
  const double error = 0.9 * wanted; // nobody uses all that is allowed
  const double factor = std::pow(error, -law.power);
  table.addRow({law.method, wanted, 1.0, law.triangles * factor, law.select * factor, law.uploads,
                law.frame * factor, error, std::int64_t(0), std::int64_t(0), overshoots, 10.0, std::string(),
                8.0, wanted});
}

TeTable tableOf(const std::vector<Law>& laws, std::vector<double> wanted = {0.5, 1, 2, 4, 8, 16, 32}) {
  TeTable table = emptyTable();
  for (const Law& law : laws)
    for (const double pixels : wanted)
      add(table, law, pixels);
  return table;
}

void addExact(TeTable& table) {
  table.addRow({std::string("brute"),
                0.0,
                {},
                1e6,
                0.05,
                0.0,
                100.0,
                0.0,
                std::int64_t(0),
                std::int64_t(0),
                std::int64_t(0),
                10.0,
                std::string(),
                4.0,
                0.0});
}

void expectSays(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is not in: " << text;
}

TEST(AccuracyCurve, LiesBetweenWhatWasMeasuredOnLogarithmicScales) {
  const TeTable table = tableOf({{"a", 1000, 1, 10, 0.7}});
  const std::vector<TeLodCurve> curves = teLodCurves(table);
  ASSERT_EQ(curves.size(), 1u);
  for (const double error : {0.45, 0.5, 1.0, 3.3, 28.8})
    EXPECT_NEAR(curves[0].at("triangles", error).value(), 1000 * std::pow(error, -0.7), 1e-6) << error;
  EXPECT_NEAR(curves[0].at("triangles", 32).value(), 1000 * std::pow(32, -0.7), 1e-6) << "a little beyond";
  EXPECT_FALSE(curves[0].at("triangles", 40));
  EXPECT_FALSE(curves[0].at("triangles", 0.3));
  EXPECT_FALSE(curves[0].isExact());
}

TEST(AccuracyCurve, OneForEachMethodAndLayout) {
  TeTable table = tableOf({{"a", 1000, 1, 10, 1}, {"b", 1000, 1, 10, 1}});
  table.addRow({std::string("b"),
                4.0,
                1.0,
                1.0,
                1.0,
                1.0,
                {},
                3.0,
                std::int64_t(0),
                std::int64_t(0),
                std::int64_t(0),
                1.0,
                std::string("4/2"),
                8.0,
                4.0});
  addExact(table);
  const std::vector<TeLodCurve> curves = teLodCurves(table);
  ASSERT_EQ(curves.size(), 4u);
  EXPECT_EQ(curves[0].name(), "a");
  EXPECT_EQ(curves[1].name(), "b");
  EXPECT_EQ(curves[2].name(), "b 4/2");
  EXPECT_FALSE(curves[2].at("frame_ms", 3)) << "was not measured";
  EXPECT_TRUE(curves[3].isExact());
  EXPECT_EQ(curves[3].at("triangles", 5), 1e6);
}

TEST(AccuracyVerdict, NamesTheBestAndHowManyTimesTheOthersNeed) {
  TeTable table =
      tableOf({{"few", 10000, 4, 20, 1}, {"quick", 25000, 0.5, 15, 1}, {"middle", 15000, 1, 18, 1}});
  addExact(table);
  const TeLodVerdict verdict(table);
  ASSERT_EQ(verdict.errors().size(), 7u);
  const std::string text = verdict.best(1);
  expectSays(
      text,
      "**At 1 px** few needs the fewest triangles, 10,000; middle 1.5 times and quick 2.5 times as many");
  expectSays(text, "quickest by quick, 0.5 ms");
  expectSays(text,
             "Frames are shortest by quick, 15.0 ms, although it has 2.5 times the triangles of few: it "
             "selects in 0.5 ms, not 4");
  expectSays(text, "Drawing everything (brute) takes 100 times the triangles and 6.7 times the frame time");
  expectSays(verdict.ratios(), "| 1 | 10,000 | 1.00 | 2.50 | 1.50 | 100.00 |");
}

TEST(AccuracyVerdict, SaysWhyAFrameIsShortest) {
  expectSays(TeLodVerdict(tableOf({{"a", 100, 1, 10, 1}, {"b", 200, 1, 20, 1}})).best(1),
             "shortest by a, 10.0 ms, as it has the fewest triangles; b 2 times as long");
  expectSays(TeLodVerdict(tableOf({{"a", 100, 1, 20, 1, 9000}, {"b", 200, 1, 10, 1}})).best(1),
             "a sends 9 times the bytes a frame");
  expectSays(TeLodVerdict(tableOf({{"a", 100, 1, 21, 1}, {"b", 200, 1, 11, 1}})).best(1),
             "a triangle of it takes 50,000 ns to send and draw, not 200,000");
  expectSays(TeLodVerdict(tableOf({{"a", 100, 1, 10, 1}, {"b", 200, 1, 10.5, 1}})).best(1),
             "shortest by a, 10.0 ms (b: alike, less than a tenth more)");
}

TEST(AccuracyVerdict, TheOrderMayTurnFromErrorToError) {
  const TeTable table = tableOf({{"steep", 10000, 1, 10, 1.2}, {"shallow", 10000, 1, 10, 0.6}});
  const TeLodVerdict verdict(table);
  expectSays(verdict.best(0.5), "shallow needs the fewest");
  expectSays(verdict.best(32), "steep needs the fewest");
}

TEST(AccuracyVerdict, WhatTenTimesTheAccuracyCosts) {
  const TeTable table = tableOf({{"steep", 10000, 1, 10, 1}, {"shallow", 10000, 1, 10, std::log10(4)}});
  expectSays(
      TeLodVerdict(table).tenfold(),
      "1 px in place of 10 px, costs steep 10.0 times the triangles, 10.0 times the selection, 10.0 times "
      "the frame; shallow 4 times the triangles");
  EXPECT_EQ(TeLodVerdict(tableOf({{"a", 1, 1, 1, 1}, {"b", 1, 1, 1, 1}}, {1, 2, 4})).tenfold(), "");
}

TEST(AccuracyVerdict, SaysWhetherPromisesHold) {
  TeTable table = tableOf({{"good", 10000, 1, 10, 1}});
  expectSays(TeLodVerdict(table).promises(), "**What is promised holds**");
  expectSays(TeLodVerdict(table).promises(), "0.9 of the wanted one");
  add(table, {"bad", 10000, 1, 10, 1}, 4, 3);
  const std::string text = TeLodVerdict(table).promises();
  expectSays(text, "**Promises broken**: bad at 4 px (3 frames above the bound");
  EXPECT_EQ(text.find("good"), std::string::npos);
}

TEST(AccuracyVerdict, WhoPromisesNothingBreaksNoPromise) {
  TeTable table = tableOf({{"good", 10000, 1, 10, 1}});
  table.addRow({std::string("careless"), 4.0, 1.0, 100.0, 1.0, 0.0, 10.0, 6.0, std::int64_t(0),
                std::int64_t(0), std::int64_t(0), 1.0, std::string(), 4.0, INFINITY});
  const std::string text = TeLodVerdict(table).promises();
  expectSays(text, "What is promised holds");
  expectSays(text, "The largest true error is 0.9 of");
  expectSays(text, "careless promises nothing; its errors are up to 1.5 of the wanted one");
}

TEST(AccuracyVerdict, LittleWasMeasured) {
  EXPECT_EQ(TeLodVerdict(emptyTable()).paragraphs().size(), 1u);
  const TeTable one = tableOf({{"only", 10000, 1, 10, 1}}, {4});
  EXPECT_EQ(TeLodVerdict(one).best(4), "");
  EXPECT_TRUE(TeLodVerdict(one).errors().empty());
  expectSays(TeLodVerdict(one).memory(), "only 8");
}

} // namespace
