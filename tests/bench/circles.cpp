#include "tests/bench/TeSourceBenchmark.h"

namespace {

void map(benchmark::State& state) { teSourceBenchmark(state, "circles"); }
void points(benchmark::State& state) { tePointBenchmark(state, "circles"); }

} // namespace

BENCHMARK(map)->Name("circles/map of 1000 circles")->Arg(65)->Arg(257)->Arg(1025);
BENCHMARK(points)->Name("circles/every n-th sample")->Arg(1)->Arg(8)->Arg(64);
