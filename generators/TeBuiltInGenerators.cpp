#include "generators/TeBuiltInGenerators.h"

#include "generators/TeGeneratorRegistry.h"
#include "generators/circles/TeCirclesGenerator.h"
#include "generators/elevation/TeElevationGenerator.h"
#include "generators/faults/TeFaultGenerator.h"
#include "generators/filters/TeBandFilter.h"
#include "generators/filters/TeMatrixFilter.h"
#include "generators/function/TeFunctionGenerator.h"
#include "generators/midpoint/TeMidpointGenerator.h"
#include "generators/noise/TeNoiseGenerator.h"

namespace {

template <class Generator> void generator(TeGeneratorRegistry& registry, const char* help) {
  [[maybe_unused]] const TeStatus ok =
      registry.addGenerator(Generator().name(), help, [] { return std::make_unique<Generator>(); });
  assert(ok);
}

template <class Filter> void filter(TeGeneratorRegistry& registry, const char* help) {
  [[maybe_unused]] const TeStatus ok =
      registry.addFilter(Filter().name(), help, [] { return std::make_unique<Filter>(); });
  assert(ok);
}

} // namespace

void teAddBuiltInGenerators(TeGeneratorRegistry& registry) {
  generator<TeFaultGenerator>(registry, "fault formation: lines through the map, one side of each rises");
  generator<TeMidpointGenerator>(registry, "midpoint displacement; maps of 2^n + 1 samples a side");
  generator<TeCirclesGenerator>(registry, "circles: cosine hills and hollows of random place and size");
  generator<TeFunctionGenerator>(registry, "height given by a function z = f(x, y)");
  generator<TeNoiseGenerator>(
      registry, "gradient noise: hills, mountain crests or folded land, exact far from the origin");
  filter<TeBandFilter>(registry, "linear filter along rows and columns, both ways");
  filter<TeMatrixFilter>(registry, "weighted mean of each sample's neighbourhood");
  generator<TeElevationGenerator>(registry, "real elevation data from a file");
}
