namespace {
constexpr int kLanes = 1;
}

#include "generators/noise/TeNoiseLoops.h"

const TeNoiseKernel teNoiseKernelScalar{TeNoiseKernel::Path::Scalar, "scalar", noiseRow, noisePoints};
