# The loops of gradient noise, once per instruction set (TeNoiseKernel.h). They rest on the optimiser for
# vectors, so they get -O3 in every build that optimises at all.
set(noise_optimised $<$<NOT:$<CONFIG:Debug>>:-O3>)
set_source_files_properties(noise/TeNoiseKernelBaseline.cpp PROPERTIES COMPILE_OPTIONS "${noise_optimised}")
set_source_files_properties(noise/TeNoiseKernelScalar.cpp PROPERTIES
  COMPILE_OPTIONS "${noise_optimised};-fno-tree-vectorize;-fno-tree-slp-vectorize")
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
  set_source_files_properties(noise/TeNoiseKernelAvx2.cpp PROPERTIES
    COMPILE_OPTIONS "${noise_optimised};-mavx2")
  set_source_files_properties(noise/TeNoiseKernelAvx512.cpp PROPERTIES
    COMPILE_OPTIONS "${noise_optimised};-mavx512f;-mavx512dq;-mavx512vl;-mprefer-vector-width=512")
endif()
