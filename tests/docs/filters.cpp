// The examples of docs/filters.md and docs/functions.md.

#include "generators/TeGeneratorRegistry.h"
#include "generators/TeRegionChooser.h"
#include "generators/filters/TeBandFilter.h"
#include "generators/function/TeFunctionGenerator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

//! [chain]
/// Faults, smoothed by five passes of the band filter and then by a matrix.
TeResult<TeHeightSourcePtr> smoothFaults() {
  return TeGeneratorRegistry::instance().source("faults:faults=80",
                                                {"band:k=0.9,passes=5", "matrix:coefficients=gauss,size=5"});
}
//! [chain]

//! [apply]
/// The same filter set by hand over a source of one's own.
TeResult<TeHeightSourcePtr> smooth(TeHeightSourcePtr source) {
  TeBandFilter filter;
  filter.k = 0.8;
  filter.passes = 3;
  return filter.apply(std::move(source));
}
//! [apply]

//! [function]
/// A volcano as a text, and a cone as a function of the program's own.
TeResult<TeHeightSourcePtr> volcano() {
  return TeGeneratorRegistry::instance().source(
      "function:z=\"800*exp(-(x^2 + y^2)/900^2) - 500*exp(-(x^2 + y^2)/150^2)\"");
}

TeResult<TeHeightSourcePtr> cone() {
  TeFunctionGenerator generator;
  generator.function = [](double x, double y) { return 500.0 - std::sqrt(x * x + y * y); };
  generator.functionName = "cone of 500 m";
  if (TeStatus ok = generator.updateParams(); !ok)
    return ok.error();
  return generator.source();
}
//! [function]

//! [regions]
/// Ridged mountains in a disc of 20 maps around the origin, faults elsewhere.
TeResult<TeRegionChooser> mountainsInTheMiddle() {
  const TeGeneratorRegistry& registry = TeGeneratorRegistry::instance();
  const auto faults = registry.source("faults");
  const auto mountains = registry.source("noise:type=ridged");
  if (!faults)
    return faults.error();
  if (!mountains)
    return mountains.error();
  TeRegionChooser chooser(*faults);
  if (TeStatus ok = chooser.addDisc({0, 0}, 20, *mountains); !ok)
    return ok.error();
  return chooser;
}
//! [regions]

TEST(Filters, TheExamplesRun) {
  const TeMapRequest request = TeMapRequest::standalone(65, 65, 1, 1).value();
  const auto rough = TeGeneratorRegistry::instance().source("faults:faults=80").value();
  const auto chain = smoothFaults();
  ASSERT_TRUE(chain.ok());
  const auto steepest = [&request](const TeHeightSourcePtr& source) {
    const TeHeightMap map = source->generate(request).value();
    float most = 0;
    for (int y = 0; y < 65; ++y)
      for (int x = 1; x < 65; ++x)
        most = std::max(most, std::fabs(map.at(x, y) - map.at(x - 1, y)));
    return most;
  };
  EXPECT_LT(steepest(*chain), steepest(rough));
  EXPECT_LT(steepest(smooth(rough).value()), steepest(rough));
}

TEST(Functions, TheExamplesRun) {
  const TeMapRequest request = TeMapRequest::standalone(3, 3, 1000, 0).value();
  EXPECT_NEAR(volcano().value()->generate(request).value().at(0, 0), 300, 0.01);
  EXPECT_NEAR(cone().value()->generate(request).value().at(1, 0), -500, 0.01);
}

TEST(Regions, TheExampleRuns) {
  const auto chooser = mountainsInTheMiddle();
  ASSERT_TRUE(chooser.ok());
  EXPECT_EQ(chooser->choose({3, 4})->name(), "noise");
  EXPECT_EQ(chooser->choose({30, 4})->name(), "faults");
}

} // namespace
