namespace {
constexpr int kLanes = 4;
}

#include "generators/noise/TeNoiseLoops.h"

#if defined(__x86_64__)
const TeNoiseKernel teNoiseKernelAvx2{TeNoiseKernel::Path::Avx2, "avx2", noiseRow, noisePoints};
#endif
