#pragma once

#include "generators/noise/TeNoisePlan.h"

#include <cstdint>
#include <vector>

/// The loops of gradient noise, compiled once per instruction set from the same text (TeNoiseLoops.inl). Every
/// path gives the same bits: all use the same IEEE double operations in the same order, none contracts
/// products and sums. Thread-safe.
class TeNoiseKernel {
public:
  enum class Path {
    Scalar,   ///< vectorisation off
    Baseline, ///< what the platform always has: SSE2 on x86-64
    Avx2,
    Avx512 ///< F, DQ, VL
  };

  /// Heights of `count` samples of a row. `halfX`, `halfY`: half cells of the sample lattice from the world's
  /// origin to the first one; the others follow eastward, 2 half cells apart.
  using Row = void (*)(const TeNoisePlan& plan, std::int64_t halfX, std::int64_t halfY, int count,
                       float* heights);
  /// Heights of `count` samples anywhere. The same bits as in a row.
  using Points = void (*)(const TeNoisePlan& plan, const std::int64_t* halfX, const std::int64_t* halfY,
                          int count, float* heights);

  Path path;
  const char* name;
  Row row;
  Points points;

  /// The paths that this processor can run, Scalar first, the widest last.
  static const std::vector<TeNoiseKernel>& available();
  /// The widest of them.
  static const TeNoiseKernel& best() { return available().back(); }
};

/// One per translation unit of TeNoiseLoops.inl.
extern const TeNoiseKernel teNoiseKernelScalar;
extern const TeNoiseKernel teNoiseKernelBaseline;
#if defined(__x86_64__)
extern const TeNoiseKernel teNoiseKernelAvx2;
extern const TeNoiseKernel teNoiseKernelAvx512;
#endif
