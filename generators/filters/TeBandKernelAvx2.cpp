#define TE_BAND_LANES 8
#include "generators/filters/TeBandKernelBody.inl"

const TeBandKernel TeBandKernel::avx2 = {"avx2", kLanes, ::sweep<false>, ::sweep<true>, ::transpose};
