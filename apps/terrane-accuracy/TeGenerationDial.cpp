#include "apps/terrane-accuracy/TeGenerationDial.h"

#include "apps/terrane-accuracy/TePlainGenerators.h"
#include "generators/filters/TeBandGrid.h"
#include "generators/noise/TeNoiseSource.h"

#include <cmath>

namespace {

TeMapRequest requestOf(int samples, std::uint64_t seed) {
  return TeMapRequest::standalone(samples, samples, 1.0, seed).value();
}

/// As many faults of ever smaller amounts as are wanted, those of the default parameters first.
std::shared_ptr<const TeFaultFormation> faultsOf(double count) {
  TeFaultParameters parameters;
  const double fall = (std::sqrt(parameters.first / parameters.last) - 1) / (parameters.faults - 1);
  const double root = 1 + (count - 1) * fall;
  parameters.faults = int(count);
  parameters.last = parameters.first / (root * root);
  return TeFaultFormation::create(parameters).value();
}

TeGenerationDial faults(int samples) {
  TeGenerationDial dial;
  dial.generator = "faults";
  dial.name = "faults";
  dial.values = {10, 30, 75, 150, 300, 600, 1200, 2400, 4800};
  dial.reference = 20000;
  dial.make = [samples](double value, std::uint64_t seed) {
    return faultsOf(value)->generate(requestOf(samples, seed)).value();
  };
  dial.arithmetic = {
      150,
      [samples](std::uint64_t seed) { return tePlainFaults(*faultsOf(150), requestOf(samples, seed)); },
      {}};
  return dial;
}

std::shared_ptr<const TeCircles> circlesOf(double count) {
  TeCirclesParameters parameters;
  parameters.circles = int(count);
  return TeCircles::create(parameters).value();
}

TeGenerationDial circles(int samples) {
  TeGenerationDial dial;
  dial.generator = "circles";
  dial.name = "iterations";
  dial.values = {30, 100, 300, 1000, 3000, 10000};
  dial.reference = 100000;
  dial.converges = false;
  dial.make = [samples](double value, std::uint64_t seed) {
    return circlesOf(value)->generate(requestOf(samples, seed)).value();
  };
  dial.arithmetic = {
      1000,
      [samples](std::uint64_t seed) { return tePlainCircles(*circlesOf(1000), requestOf(samples, seed)); },
      {}};
  return dial;
}

/// The map after so many levels, the other samples between those that are set: levels do not change what
/// coarser ones have set.
TeHeightMap afterLevels(TeHeightMap map, int step) {
  const int last = map.width() - 1;
  for (int y = 0; y <= last; y += step)
    for (int x = 0; x < last; x += step)
      for (int i = 1; i < step; ++i)
        map.at(x + i, y) = float(map.at(x, y) + (double(map.at(x + step, y)) - map.at(x, y)) * i / step);
  for (int y = 0; y < last; y += step)
    for (int i = 1; i < step; ++i)
      for (int x = 0; x <= last; ++x)
        map.at(x, y + i) = float(map.at(x, y) + (double(map.at(x, y + step)) - map.at(x, y)) * i / step);
  return map;
}

TeGenerationDial midpoint(int samples) {
  const int levels = int(std::lround(std::log2(samples - 1)));
  const std::shared_ptr<const TeMidpointDisplacement> source = TeMidpointDisplacement::create({}).value();
  TeGenerationDial dial;
  dial.generator = "midpoint";
  dial.name = "levels";
  for (int level = std::max(1, levels - 6); level < levels; ++level)
    dial.values.push_back(level);
  dial.reference = levels;
  dial.make = [source, samples, levels](double value, std::uint64_t seed) {
    return afterLevels(source->generate(requestOf(samples, seed)).value(), 1 << (levels - int(value)));
  };
  // Another map than the one looked at, but as much work.
  dial.work = [source](double value, std::uint64_t seed) {
    (void)source->generate(requestOf((1 << int(value)) + 1, seed)).value();
  };
  dial.arithmetic = {
      double(levels),
      [source, samples](std::uint64_t seed) { return tePlainMidpoint(*source, requestOf(samples, seed)); },
      {}};
  return dial;
}

/// Octaves weighted as in the sum of all, so that fewer are a part of it.
TeGenerationDial noise(int samples) {
  TeGenerationDial dial;
  dial.generator = "noise";
  dial.name = "octaves";
  dial.values = {1, 2, 3, 4, 5, 6, 8, 10};
  dial.reference = TeNoiseSettings::kMaxOctaves;
  dial.make = [samples](double value, std::uint64_t seed) {
    TeNoiseSettings settings;
    const double all = 1 - std::pow(settings.gain, TeNoiseSettings::kMaxOctaves);
    settings.octaves = int(value);
    settings.amplitude *= (1 - std::pow(settings.gain, value)) / all;
    return TeNoiseSource::create(settings).value()->generate(requestOf(samples, seed)).value();
  };
  return dial;
}

/// The k with which so many passes blur as much as the defaults do: a pass there and back adds a variance
/// of 2(1-k)/k² samples² in each direction.
double bandOf(double passes) {
  constexpr double kDefault = 0.9;
  constexpr double kVariance = 5 * 2 * (1 - kDefault) / (kDefault * kDefault);
  return (std::sqrt(passes * passes + 2 * passes * kVariance) - passes) / kVariance;
}

/// The filter alone, over a map that is there.
TeHeightMap banded(TeHeightMap map, double passes) {
  TeBandGrid grid(map.width(), map.height());
  grid.load(map, 0, map.height());
  grid.begin(float(bandOf(passes)), int(passes));
  while (grid.unit())
    ;
  grid.store(map, 0, map.height());
  return map;
}

TeGenerationDial band(int samples) {
  const auto input = [samples](std::uint64_t seed) {
    return faultsOf(150)->generate(requestOf(samples, seed)).value();
  };
  const auto timed = std::make_shared<const TeHeightMap>(input(0));
  TeGenerationDial dial;
  dial.generator = "band";
  dial.name = "passes";
  dial.values = {1, 2, 3, 5, 8, 16, 32, 64};
  dial.reference = 512;
  dial.make = [input](double value, std::uint64_t seed) { return banded(input(seed), value); };
  dial.work = [timed](double value, std::uint64_t) { (void)banded(*timed, value); };
  dial.arithmetic = {5,
                     [samples, input](std::uint64_t seed) {
                       TeDoubleHeights heights = teInDouble(input(seed));
                       tePlainBand(heights, samples, samples, float(bandOf(5)), 5);
                       return heights;
                     },
                     [samples, timed] {
                       TeDoubleHeights heights = teInDouble(*timed);
                       tePlainBand(heights, samples, samples, float(bandOf(5)), 5);
                     }};
  return dial;
}

} // namespace

std::vector<TeGenerationDial> teGenerationDials(int samples) {
  return {faults(samples), circles(samples), midpoint(samples), noise(samples), band(samples)};
}
