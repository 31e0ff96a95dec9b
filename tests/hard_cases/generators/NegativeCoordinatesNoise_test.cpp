#include "generators/noise/TeNoiseSource.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

// Truncation in place of floor division tears noise at the axes; a wrong neighbour tears it at cell borders.
TEST(HardCase, NegativeCoordinatesNoise) {
  TeNoiseSettings settings;
  settings.wavelength = 100;
  settings.octaves = 2;
  settings.warp = 10;
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
    // The slope of raw noise is below 3.3 a cell: gradients of length 1, and fade' ≤ 1.875 times corner
    // values that differ by at most √2 between cell sides. Octaves of half the size and half the cell add the
    // same slope; folding and squaring at most doubles one and, with the weight of the octave before, adds
    // half of the other's; a displacement stretches by its own slope.
    const double plain = settings.amplitude * TeNoisePlan::kUnit * 3.3 / settings.wavelength * (2 / 1.5);
    const double factor = type == TeNoiseType::Fbm ? 1 : type == TeNoiseType::Ridged ? 8 : 1.7;
    std::printf("noise type %d: steepest step %.4f m, bound %.4f m\n", int(type), steepest,
                plain * factor * spacing);
    EXPECT_LE(steepest, plain * factor * spacing);
    EXPECT_GT(steepest, 0.05 * plain * spacing);
  }
}
