#include "generators/noise/TeNoiseKernel.h"

const std::vector<TeNoiseKernel>& TeNoiseKernel::available() {
  static const std::vector<TeNoiseKernel> kernels = [] {
    std::vector<TeNoiseKernel> usable{teNoiseKernelScalar, teNoiseKernelBaseline};
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2"))
      usable.push_back(teNoiseKernelAvx2);
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl"))
      usable.push_back(teNoiseKernelAvx512);
#endif
    return usable;
  }();
  return kernels;
}
