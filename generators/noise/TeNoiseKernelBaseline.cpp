namespace {
constexpr int kLanes = 2;
}

#include "generators/noise/TeNoiseLoops.inl"

const TeNoiseKernel teNoiseKernelBaseline{TeNoiseKernel::Path::Baseline, "baseline", noiseRow, noisePoints};
