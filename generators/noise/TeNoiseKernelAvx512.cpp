#if defined(__x86_64__)

namespace {
constexpr int kLanes = 8;
}

#include "generators/noise/TeNoiseLoops.inl"

const TeNoiseKernel teNoiseKernelAvx512{TeNoiseKernel::Path::Avx512, "avx512", noiseRow, noisePoints};

#endif
