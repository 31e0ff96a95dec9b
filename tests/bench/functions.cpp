#include "generators/TeGeneratorRegistry.h"
#include "generators/base/TeMath.h"
#include "generators/base/TeRandom.h"
#include "tests/bench/TeBenchmarkReport.h"

#include <cmath>
#include <string>
#include <vector>

namespace {

void functionMap(benchmark::State& state, const char* z) {
  const auto source = TeGeneratorRegistry::instance().source("function:z=\"" + std::string(z) + "\"").value();
  const TeMapRequest request = TeMapRequest::sourceMap(TeLattice::create(65, 1).value(), 1, {2, 3});
  teBenchmark(state, {65 * 65, 65 * 65 * sizeof(float)},
              [&] { benchmark::DoNotOptimize(source->generate(request).value().data()); });
}

void plane(benchmark::State& state) { functionMap(state, "0.1*x + 0.2*y"); }
void waves(benchmark::State& state) { functionMap(state, "20*sin(x/50)*cos(y/50)"); }
void hill(benchmark::State& state) { functionMap(state, "100*exp(-(x^2 + y^2)/500^2)"); }

/// One elementary function, ours or the C library's, over angles up to 100.
template <class Function> void elementary(benchmark::State& state, Function function) {
  TeRandom random(1, 1, {});
  std::vector<double> x(4096);
  for (double& value : x)
    value = random.uniform(-100.0, 100.0);
  teBenchmark(state, {4096, 4096 * sizeof(double)}, [&] {
    double sum = 0;
    for (double value : x)
      sum += function(value);
    benchmark::DoNotOptimize(sum);
  });
}

void ourSine(benchmark::State& state) { elementary(state, teSin); }
void librarySine(benchmark::State& state) {
  elementary(state, [](double x) { return std::sin(x); });
}
void ourExponential(benchmark::State& state) { elementary(state, teExp); }
void libraryExponential(benchmark::State& state) {
  elementary(state, [](double x) { return std::exp(x); });
}

} // namespace

BENCHMARK(plane)->Name("function/plane, map of 65x65");
BENCHMARK(waves)->Name("function/sine waves, map of 65x65");
BENCHMARK(hill)->Name("function/gaussian hill, map of 65x65");
BENCHMARK(ourSine)->Name("function/sine, ours");
BENCHMARK(librarySine)->Name("function/sine, C library");
BENCHMARK(ourExponential)->Name("function/exp, ours");
BENCHMARK(libraryExponential)->Name("function/exp, C library");
