#define TE_BAND_LANES 4
#include "generators/filters/TeBandKernelBody.inl"

const TeBandKernel TeBandKernel::baseline = {"baseline", kLanes, ::sweep<false>, ::sweep<true>, ::transpose};
