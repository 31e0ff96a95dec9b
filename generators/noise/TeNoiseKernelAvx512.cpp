namespace {
constexpr int kLanes = 8;
}

#include "generators/noise/TeNoiseLoops.h"

#if defined(__x86_64__)
const TeNoiseKernel teNoiseKernelAvx512{TeNoiseKernel::Path::Avx512, "avx512", noiseRow, noisePoints};
#endif
