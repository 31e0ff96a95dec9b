#include "generators/filters/TeBandKernel.h"

const TeBandKernel& TeBandKernel::best() {
#if defined(__x86_64__)
  static const TeBandKernel& chosen = []() -> const TeBandKernel& {
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx512f"))
      return avx512;
    if (__builtin_cpu_supports("avx2"))
      return avx2;
    return baseline;
  }();
  return chosen;
#else
  return baseline;
#endif
}
