namespace {
constexpr int kLanes = 1;
}

#include "generators/noise/TeNoiseLoops.inl"

const TeNoiseKernel teNoiseKernelScalar{TeNoiseKernel::Path::Scalar, "scalar", noiseRow, noisePoints};
