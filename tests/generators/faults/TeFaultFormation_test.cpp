#include "generators/faults/TeFaultFormation.h"

#include "generators/TeGeneratorRegistry.h"
#include "tests/generators/mapsInParts.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using Source = std::shared_ptr<const TeFaultFormation>;

Source make(const std::string& profile, int faults = 150, bool centred = true) {
  TeFaultParameters parameters;
  parameters.profile = profile;
  parameters.faults = faults;
  parameters.centred = centred;
  return *TeFaultFormation::create(parameters);
}

TeMapRequest mapOf(int columns, int rows, TeMapKey key = {}) {
  TeMapRequest request = *TeMapRequest::standalone(columns, rows, 1.0, 7);
  request.key = key;
  return request;
}

/// The document's loop: for each fault, a test of every sample.
TeHeightMap plainLoop(const TeFaultFormation& source, const TeMapRequest& request) {
  const std::size_t samples = std::size_t(request.columns) * std::size_t(request.rows);
  std::vector<std::int64_t> units(samples, 0);
  std::int64_t all = 0;
  for (int f = 0; f < source.faults(); ++f) {
    const TeFaultLine line = source.line(request, source.random(request), f);
    const std::int64_t dx = line.bx - line.ax;
    const std::int64_t dy = line.by - line.ay;
    all += source.amplitude(f);
    for (int r = 0; r < request.rows; ++r)
      for (int c = 0; c < request.columns; ++c)
        if (dx * (256 * std::int64_t(r) + 128 - line.ay) - dy * (256 * std::int64_t(c) + 128 - line.ax) > 0)
          units[std::size_t(r) * std::size_t(request.columns) + std::size_t(c)] += source.amplitude(f);
  }
  TeHeightMap map = *TeHeightMap::create(request.columns, request.rows);
  for (std::size_t i = 0; i < samples; ++i) {
    const double metres = source.parameters().centred ? (double(units[i]) - 0.5 * double(all)) * source.unit()
                                                      : double(units[i]) * source.unit();
    map.data()[i] = float(metres);
  }
  return map;
}

/// The same with the profile of each fault evaluated in every sample.
TeHeightMap plainSmoothLoop(const TeFaultFormation& source, const TeMapRequest& request) {
  TeHeightMap map = *TeHeightMap::create(request.columns, request.rows);
  for (int r = 0; r < request.rows; ++r)
    for (int c = 0; c < request.columns; ++c) {
      std::int64_t sum = 0;
      for (int f = 0; f < source.faults(); ++f) {
        const TeFaultPlane plane = source.plane(request, source.random(request), f);
        sum += plane.smoothHeight(plane.value(c, r)) + plane.base * TeFaultPlane::kRampFull;
      }
      source.heights(&sum, 1, &map.at(c, r));
    }
  return map;
}

const TeMapKey kKeys[] = {{0, 0}, {1, 0}, {-3, 5}, {std::int64_t(1) << 40, -(std::int64_t(1) << 47)}};

} // namespace

TEST(TeFaultFormation, SpansGiveTheBitsOfTheSideTestPerSampleAndFault) {
  for (const TeMapKey& key : kKeys)
    for (bool centred : {true, false})
      EXPECT_EQ(*make("step", 150, centred)->generate(mapOf(65, 65, key)),
                plainLoop(*make("step", 150, centred), mapOf(65, 65, key)));
}

TEST(TeFaultFormation, SmoothDifferencesGiveTheBitsOfTheProfilePerSampleAndFault) {
  for (const TeMapKey& key : kKeys)
    EXPECT_EQ(*make("smooth")->generate(mapOf(65, 65, key)),
              plainSmoothLoop(*make("smooth"), mapOf(65, 65, key)));
}

TEST(TeFaultFormation, MapsOfAnySizeHaveTheBitsOfThePlainLoop) {
  for (auto [columns, rows] :
       {std::pair(1, 1), {1, 70}, {70, 1}, {2, 3}, {33, 129}, {2048, 2}, {2049, 3}, {5000, 2}}) {
    EXPECT_EQ(*make("step")->generate(mapOf(columns, rows)), plainLoop(*make("step"), mapOf(columns, rows)))
        << columns << "x" << rows;
    EXPECT_EQ(*make("smooth")->generate(mapOf(columns, rows)),
              plainSmoothLoop(*make("smooth"), mapOf(columns, rows)))
        << columns << "x" << rows;
  }
}

TEST(TeFaultFormation, AnySlicingGivesTheSameBits) {
  for (const char* profile : {"step", "smooth"}) {
    const Source source = make(profile, 2500);
    const TeMapRequest request = mapOf(65, 65);
    const TeHeightMap whole = *source->generate(request);
    for (std::int64_t units : {1, 2, 7})
      expectMapInSlices(*source, request, units, whole);
  }
}

TEST(TeFaultFormation, ScatteredSamplesHaveTheBitsOfTheMap) {
  for (const char* profile : {"step", "smooth"})
    for (int stride : {1, 4, 32})
      expectSamplesOfMap(*make(profile), mapOf(65, 33, {4, -9}), stride);
}

TEST(TeFaultFormation, HeightsStayWithinTheSumOfAmplitudes) {
  const Source source = make("step", 150, false);
  double sum = 0;
  for (int f = 0; f < source->faults(); ++f)
    sum += double(source->amplitude(f)) * source->unit();
  EXPECT_NEAR(double(source->amplitude(0)) * source->unit(), source->parameters().first, source->unit());
  EXPECT_NEAR(double(source->amplitude(149)) * source->unit(), source->parameters().last, source->unit());
  double mean = 0;
  for (int k = 0; k < 100; ++k) {
    const TeMapStatistics s = source->generate(mapOf(33, 33, {k, 0}))->statistics();
    EXPECT_GE(s.minimum, 0.0f);
    EXPECT_LE(s.maximum, sum);
    EXPECT_GT(s.maximum - s.minimum, source->parameters().first);
    mean += s.mean / 100;
  }
  EXPECT_NEAR(mean, sum / 2, 0.1 * sum);
}

// The profile's formula by itself: two parabolas over the distance from the line, in the given width.
TEST(TeFaultFormation, SmoothFaultsRiseAcrossTheGivenWidth) {
  TeFaultParameters parameters;
  parameters.profile = "smooth";
  parameters.faults = 1;
  parameters.first = parameters.last = 8;
  parameters.width = 20;
  parameters.centred = false;
  const Source source = *TeFaultFormation::create(parameters);
  for (int k = 0; k < 20; ++k) {
    const TeMapRequest request = mapOf(65, 65, {k, k});
    const TeHeightMap map = *source->generate(request);
    const TeFaultLine line = source->line(request, source->random(request), 0);
    const double dx = double(line.bx - line.ax), dy = double(line.by - line.ay);
    for (int r = 0; r < 65; ++r)
      for (int c = 0; c < 65; ++c) {
        const double cross =
            dx * (256.0 * r + 128 - double(line.ay)) - dy * (256.0 * c + 128 - double(line.ax));
        const double t = std::min(1.0, std::max(0.0, 0.5 + cross / std::hypot(dx, dy) / 256 / 20));
        const double height = 8 * (t < 0.5 ? 2 * t * t : 1 - 2 * (1 - t) * (1 - t));
        EXPECT_NEAR(map.at(c, r), height, 0.01) << c << " " << r;
      }
  }
}

TEST(TeFaultFormation, MapsDifferByKeyWorldSeedAndOwnSeed) {
  TeFaultParameters parameters;
  const Source source = *TeFaultFormation::create(parameters);
  parameters.seed = 1;
  const Source other = *TeFaultFormation::create(parameters);
  const TeHeightMap map = *source->generate(mapOf(17, 17));
  EXPECT_EQ(map, *source->generate(mapOf(17, 17)));
  EXPECT_NE(map, *source->generate(mapOf(17, 17, {0, 1})));
  EXPECT_NE(map, *other->generate(mapOf(17, 17)));
  EXPECT_NE(source->fingerprint(), other->fingerprint());
  TeMapRequest request = mapOf(17, 17);
  request.worldSeed = 8;
  EXPECT_NE(map, *source->generate(request));
}

TEST(TeFaultFormation, RefusesParametersOutOfRange) {
  for (int faults : {0, -1, 100001})
    EXPECT_FALSE(TeGeneratorRegistry::instance().source("faults:faults=" + std::to_string(faults)));
  for (const char* text :
       {"first=0", "first=nan", "last=-1", "last=inf", "width=0", "profile=round", "seed=-1"})
    EXPECT_FALSE(TeGeneratorRegistry::instance().source(std::string("faults:") + text)) << text;
  TeFaultParameters parameters;
  parameters.first = NAN;
  EXPECT_FALSE(TeFaultFormation::create(parameters));
}

TEST(TeFaultFormation, ExtremeParametersGiveFiniteHeights) {
  for (const char* text : {"first=1e6,last=1e6,faults=1000", "first=1e-6,last=1e-6", "first=1e6,last=1e-6",
                           "first=1e-6,last=1e6", "width=1e6,profile=smooth", "width=1e-6,profile=smooth",
                           "first=1e6,last=1e6,faults=1000,profile=smooth", "faults=1"}) {
    auto source = TeGeneratorRegistry::instance().source(std::string("faults:") + text);
    ASSERT_TRUE(source) << text;
    for (double spacing : {1e-9, 1.0, 1e12}) {
      const TeHeightMap map = *(*source)->generate(*TeMapRequest::standalone(33, 9, spacing, 1));
      for (int i = 0; i < 33 * 9; ++i)
        ASSERT_TRUE(std::isfinite(map.data()[i])) << text;
    }
  }
}

// Also where many pairs of points coincide or lie along a row.
TEST(TeFaultFormation, CoincidentAndLevelPointsMakeALine) {
  const Source source = make("step", 5000);
  const TeMapRequest request = mapOf(1, 1); // 256 x 256 possible points: 5000 faults meet many level pairs
  for (int f = 0; f < source->faults(); ++f) {
    const TeFaultLine line = source->line(request, source->random(request), f);
    ASSERT_NE(line.ay, line.by);
  }
  EXPECT_EQ(*source->generate(request), plainLoop(*source, request));
}
