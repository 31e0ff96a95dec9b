#include "generators/noise/TeNoiseSource.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

// Truncation in place of floor division tears noise at the axes; a wrong neighbour tears it at cell borders.
TEST(HardCase, NegativeCoordinatesNoise) {
  TeNoiseSettings settings;
  settings.wavelength = 100;
  settings.octaves = 2;
  settings.warp = 0.1;
  settings.warpOctaves = 1;
  const double spacing = 0.25;
  for (TeNoiseType type : {TeNoiseType::Fbm, TeNoiseType::Ridged, TeNoiseType::Warp}) {
    settings.type = type;
    const TeHeightSourcePtr source = *TeNoiseSource::create(settings);
    // Steps between neighbours, around the origin: 12 cells of the first octave, 24 of the second, in both
    // directions, in all four quadrants.
    TeMapRequest request = *TeMapRequest::standalone(2400, 400, spacing, 1);
    double steepest = 0;
    for (bool north : {false, true}) {
      request.columns = north ? 400 : 2400;
      request.rows = north ? 2400 : 400;
      request.firstX = -request.columns / 2;
      request.firstY = -request.rows / 2;
      const TeHeightMap map = *source->generate(request);
      for (int y = 1; y < map.height(); ++y)
        for (int x = 1; x < map.width(); ++x)
          steepest = std::max({steepest, std::fabs(double(map.at(x, y)) - map.at(x - 1, y)),
                               std::fabs(double(map.at(x, y)) - map.at(x, y - 1))});
    }
    // The slope of raw noise is below 1 + 1.875·2 a cell, in any direction: gradients of length 1, and
    // fade' ≤ 1.875 times interpolated corners, at most 1/√2 each, whose differences across and along the
    // cell enter together. An octave of half the size and half the cell has the same slope. Folding and
    // squaring doubles a slope, the weight adds twice the first octave's signal's to the second's: 6 times in
    // all. A displacement stretches by its own slope, below 0.95 here.
    const double fbm = settings.amplitude * TeNoisePlan::kUnit * 4.75 / settings.wavelength * (2 / 1.5);
    const double factor = type == TeNoiseType::Fbm ? 1 : type == TeNoiseType::Ridged ? 6 : 1.95;
    const double bound = fbm * factor * spacing;
    std::printf("noise type %d: steepest step %.4f m, bound %.4f m\n", int(type), steepest, bound);
    EXPECT_LE(steepest, bound);
    EXPECT_GT(steepest, 0.05 * bound);
  }
}
