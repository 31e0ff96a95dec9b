#define TE_BAND_LANES 16
#include "generators/filters/TeBandKernelBody.inl"

const TeBandKernel TeBandKernel::avx512 = {"avx512", kLanes, ::sweep<false>, ::sweep<true>, ::transpose};
