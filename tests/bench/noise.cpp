#include "TeBenchmarkReport.h"

#include "generators/base/TeAllowance.h"
#include "generators/noise/TeNoiseSource.h"

#include <benchmark/benchmark.h>

#ifdef TERRANE_HAVE_LIBNOISE
#include <noise.h>
#endif

#include <algorithm>
#include <string>
#include <vector>

namespace {

constexpr int kSide = 1025;
constexpr TeNoiseType kTypes[] = {TeNoiseType::Fbm, TeNoiseType::Ridged, TeNoiseType::Warp};
constexpr const char* kTypeNames[] = {"fbm", "ridged", "warp"};

#ifdef TERRANE_HAVE_LIBNOISE
/// Heights per CPU second of libnoise's module of that kind, in standard quality, with the same octaves and
/// wavelength: the median of nine blocks of rows.
double peerHeightsPerSecond(const TeNoiseSettings& settings) {
  noise::module::Perlin perlin;
  perlin.SetOctaveCount(settings.octaves);
  perlin.SetFrequency(1 / settings.wavelength);
  perlin.SetNoiseQuality(noise::QUALITY_STD);
  noise::module::RidgedMulti ridged;
  ridged.SetOctaveCount(settings.octaves);
  ridged.SetFrequency(1 / settings.wavelength);
  ridged.SetNoiseQuality(noise::QUALITY_STD);
  noise::module::Turbulence turbulence;
  turbulence.SetSourceModule(0, perlin);
  turbulence.SetFrequency(1 / settings.wavelength);
  turbulence.SetPower(settings.warp * settings.wavelength);
  turbulence.SetRoughness(settings.warpOctaves);
  const noise::module::Module* const modules[] = {&perlin, &ridged, &turbulence};
  const noise::module::Module& module = *modules[int(settings.type)];

  constexpr int kRows = 8;
  std::vector<float> row(kSide);
  std::vector<double> seconds;
  for (int block = 0; block < 9; ++block) {
    const double start = teThreadCpuSeconds();
    for (int y = 0; y < kRows; ++y) {
      for (int x = 0; x < kSide; ++x)
        row[std::size_t(x)] = float(module.GetValue(x, block * kRows + y, 0.5));
      benchmark::ClobberMemory();
    }
    seconds.push_back(teThreadCpuSeconds() - start);
  }
  std::nth_element(seconds.begin(), seconds.begin() + 4, seconds.end());
  return kRows * kSide / seconds[4];
}
#endif

void noiseMap(benchmark::State& state, const TeNoiseSettings& settings, const TeNoiseKernel& kernel,
              int side) {
  const TeHeightSourcePtr source = *TeNoiseSource::create(settings, kernel);
  const TeMapRequest request = *TeMapRequest::standalone(side, side, 1.0, 1);
  TeBenchmarkWork work;
  work.heights = std::int64_t(side) * side;
  work.copyBytes = std::size_t(work.heights) * sizeof(float);
#ifdef TERRANE_HAVE_LIBNOISE
  const double before = peerHeightsPerSecond(settings);
#endif
  teBenchmark(state, work, [&] { benchmark::DoNotOptimize(source->generate(request)->data()); });
#ifdef TERRANE_HAVE_LIBNOISE
  const double peer = 0.5 * (before + peerHeightsPerSecond(settings));
  state.counters["libnoise/s"] = peer;
  state.counters["x_libnoise"] = state.counters["heights/s"] / peer;
  const bool portable =
      kernel.path == TeNoiseKernel::Path::Scalar || kernel.path == TeNoiseKernel::Path::Baseline;
  state.counters["target_x"] = portable ? 3 : 8;
#else
  state.SetLabel("libnoise not found: no peer");
#endif
}

void registerMap(const TeNoiseSettings& settings, const TeNoiseKernel& kernel, int side) {
  const std::string name = std::string("noise/") + kTypeNames[int(settings.type)] + "/" + kernel.name +
                           "/wavelength:" + std::to_string(int(settings.wavelength)) + "/" +
                           std::to_string(side);
  benchmark::RegisterBenchmark(name.c_str(), [settings, &kernel, side](benchmark::State& state) {
    noiseMap(state, settings, kernel, side);
  })->Unit(benchmark::kMillisecond);
}

/// Every path for every type; then the widest path where lattice cells are small and large, and a small map.
const bool registered = [] {
  TeNoiseSettings settings;
  for (TeNoiseType type : kTypes) {
    settings.type = type;
    for (const TeNoiseKernel& kernel : TeNoiseKernel::available())
      registerMap(settings, kernel, kSide);
  }
  settings.type = TeNoiseType::Fbm;
  registerMap(settings, TeNoiseKernel::best(), 65);
  for (double wavelength : {50.0, 1000.0}) {
    settings.wavelength = wavelength;
    registerMap(settings, TeNoiseKernel::best(), kSide);
  }
  return true;
}();

} // namespace
