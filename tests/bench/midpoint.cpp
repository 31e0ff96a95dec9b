#include "tests/bench/TeSourceBenchmark.h"

namespace {

void uniform(benchmark::State& state) { teSourceBenchmark(state, "midpoint"); }
void gaussian(benchmark::State& state) { teSourceBenchmark(state, "midpoint:variant=gaussian"); }

} // namespace

BENCHMARK(uniform)->Name("midpoint/map, uniform")->Arg(65)->Arg(257)->Arg(1025);
BENCHMARK(gaussian)->Name("midpoint/map, gaussian")->Arg(65)->Arg(257)->Arg(1025);
