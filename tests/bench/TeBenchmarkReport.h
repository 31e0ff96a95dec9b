#pragma once

#include "generators/base/TeAllowance.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

/// What one iteration of a benchmark does, for the figures that are printed beside its time.
struct TeBenchmarkWork {
  std::int64_t heights = 0;   ///< made, filtered, blended ...
  std::size_t copyBytes = 0;  ///< what the plain copy that it is compared with copies
  double targetCopies = 0;    ///< aim: at most that many times the copy's time; 0 = none stated
  std::size_t workingSet = 0; ///< bytes that iterations go through before they come back; 0 = copyBytes
};

/// CPU seconds of a plain copy (memcpy) of so many bytes from one place to another: the median of nine runs
/// of at least a millisecond. With a working set larger than the caches, iterations walk through it, so that
/// the copy comes from memory.
inline double teCopySeconds(std::size_t bytes, std::size_t workingSet = 0) {
  const std::size_t blocks = std::max<std::size_t>(1, workingSet / std::max<std::size_t>(1, bytes));
  std::vector<char> from(bytes * blocks, 1);
  std::vector<char> to(bytes * blocks, 2);
  std::vector<double> seconds;
  std::size_t block = 0;
  for (int run = 0; run < 9; ++run) {
    const double start = teThreadCpuSeconds();
    std::int64_t copies = 0;
    double passed = 0;
    do {
      for (int i = 0; i < 16; ++i) {
        std::memcpy(to.data() + block * bytes, from.data() + block * bytes, bytes);
        benchmark::ClobberMemory();
        block = (block + 1) % blocks;
      }
      copies += 16;
      passed = (teThreadCpuSeconds() - start);
    } while (passed < 1e-3);
    seconds.push_back(passed / double(copies));
  }
  std::nth_element(seconds.begin(), seconds.begin() + 4, seconds.end());
  return seconds[4];
}

/// Runs `work` as the benchmark's loop and prints heights/s, bytes moved (read + written by the copy) per
/// iteration, the CPU time as a multiple of the plain copy's in the same run ("copies"), and the aim for it.
template <class Work> void teBenchmark(benchmark::State& state, const TeBenchmarkWork& what, Work work) {
  const double before = what.copyBytes ? teCopySeconds(what.copyBytes, what.workingSet) : 0;
  const double start = teThreadCpuSeconds();
  for (auto _ : state)
    work();
  const double seconds =
      (teThreadCpuSeconds() - start) / double(std::max<std::int64_t>(1, state.iterations()));
  if (what.heights)
    state.counters["heights/s"] = double(what.heights) / seconds;
  if (what.copyBytes) {
    const double copy = 0.5 * (before + teCopySeconds(what.copyBytes, what.workingSet));
    state.counters["bytes"] = double(2 * what.copyBytes);
    state.counters["copies"] = seconds / copy;
    state.counters["copy_us"] = copy * 1e6;
  }
  if (what.targetCopies > 0)
    state.counters["target_copies"] = what.targetCopies;
}
