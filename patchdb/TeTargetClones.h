#pragma once

/// Compiles a function for several instruction sets, one of which is chosen when the library is loaded. Safe
/// for bit-equality only because floating-point contraction is off.
#if defined(__x86_64__) && defined(__ELF__) && defined(__GNUC__) && defined(__OPTIMIZE__) &&                 \
    !defined(__clang__) && !defined(__SANITIZE_THREAD__) && !defined(__SANITIZE_ADDRESS__)
#define TE_TARGET_CLONES __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define TE_TARGET_CLONES
#endif
