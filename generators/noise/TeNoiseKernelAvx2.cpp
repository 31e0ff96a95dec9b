#if defined(__x86_64__)

namespace {
constexpr int kLanes = 4;
}

#include "generators/noise/TeNoiseLoops.inl"

const TeNoiseKernel teNoiseKernelAvx2{TeNoiseKernel::Path::Avx2, "avx2", noiseRow, noisePoints};

#endif
