#include "apps/terrane-bake/TeSynthBase.h"

#include "generators/base/TeFloatEnvironment.h"
#include "generators/elevation/TePostDecoder.h"
#include "generators/elevation/TeRasterOpen.h"
#include "generators/noise/TeNoiseKernel.h"

#include <algorithm>
#include <cmath>

namespace {

TeNoiseSettings noise(TeNoiseType type, double wavelength, int octaves, std::uint64_t seed) {
  TeNoiseSettings settings;
  settings.type = type;
  settings.wavelength = wavelength;
  settings.octaves = octaves;
  settings.amplitude = 1;
  settings.seed = seed;
  return settings;
}

double smoothStep(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// Metres, from the noises of a place, each within ±1: where the land is, where its mountains stand, and what
/// its plains look like.
double landHeight(double land, double crests, double hills) {
  constexpr double kCoast = -0.3;
  const double inland = land - kCoast;
  if (inland <= 0)
    return 0;
  const double plain = 250 * inland + 80 * (hills + 0.4) * smoothStep(0, 0.1, inland);
  const double crest = std::max(0.0, 0.5 * (crests + 1));
  return std::max(0.0, plain) + 4800 * smoothStep(0.25, 1, inland) * crest * std::sqrt(crest);
}

} // namespace

TeResult<TeSynthBase> TeSynthBase::fromFile(const std::string& path) {
  const TeElevationOptions reading;
  TeResult<std::unique_ptr<TeRasterFile>> raster = teOpenRaster(path, reading);
  if (!raster)
    return raster.error();
  const TeRasterInfo& info = (*raster)->info();
  if (info.columns != info.rows || info.columns < 4 || info.columns > kMostSide)
    return TeError{path + ": " + std::to_string(info.columns) + "x" + std::to_string(info.rows) +
                   " heights; a square of 4 to " + std::to_string(kMostSide) + " a side is needed"};
  TeSynthBase base;
  base.side = info.columns;
  const TePostDecoder decoder(info, reading, kHeightUnit);
  std::vector<double> row(std::size_t(base.side));
  for (int y = 0; y < base.side; ++y) {
    if (TeStatus ok = (*raster)->read(1, {0, y, base.side, 1}, row.data()); !ok)
      return TeError{path + ": " + ok.error().message};
    for (double height : row) {
      if (!(height >= 0 && height <= 65535) || std::isnan(decoder.height(height)))
        return TeError{path + ": row " + std::to_string(y) +
                       " has heights that are missing or not 0 .. 65535"};
      base.heights.push_back(float(height));
    }
  }
  base.sea = *std::min_element(base.heights.begin(), base.heights.end());
  return base;
}

TeSynthBase TeSynthBase::fromNoise(std::uint64_t seed) {
  const TeFloatEnvironment environment;
  const double spacing = kExtent / (kNoiseSide - 1);
  const TeNoisePlan land(noise(TeNoiseType::Fbm, 70000, 8, 1), seed, spacing);
  const TeNoisePlan crests(noise(TeNoiseType::Ridged, 30000, 7, 2), seed, spacing);
  const TeNoisePlan hills(noise(TeNoiseType::Fbm, 6000, 5, 3), seed, spacing);
  const TeNoiseKernel& kernel = TeNoiseKernel::best();
  std::vector<float> a(kNoiseSide), b(kNoiseSide), c(kNoiseSide);
  TeSynthBase base;
  base.side = kNoiseSide;
  for (int row = 0; row < kNoiseSide; ++row) {
    const std::int64_t north = 2 * std::int64_t(kNoiseSide - 1 - row);
    kernel.row(land, 0, north, kNoiseSide, a.data());
    kernel.row(crests, 0, north, kNoiseSide, b.data());
    kernel.row(hills, 0, north, kNoiseSide, c.data());
    for (std::size_t x = 0; x < kNoiseSide; ++x) {
      // The plans promise ±amplitude; in most places they stay within a third of it.
      const double metres = landHeight(3 * double(a[x]), double(b[x]), 3 * double(c[x]));
      base.heights.push_back(float(std::min(metres / kHeightUnit, 60000.0)));
    }
  }
  return base;
}
