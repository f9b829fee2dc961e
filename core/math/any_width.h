// A function that is compiled for AVX2 too; the processor picks one when the library is loaded. Both give the
// same bits: nothing is summed in another order or contracted.
#pragma once

#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define HRT_ANY_WIDTH __attribute__((target_clones("avx2", "default")))
#else
#define HRT_ANY_WIDTH
#endif
