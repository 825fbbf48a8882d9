// Functions that are compiled once more for wider vector instructions.
#pragma once

/// Before a function's definition: it, and what is inlined into it, is compiled for x86-64 with
/// AVX2 and with AVX-512 as well, and the machine's own is taken as the program starts. The
/// loops that gain are those over arrays of floats; the results are the same bit by bit, since
/// nothing is contracted or reordered. Empty where the compiler or the machine has no such thing,
/// and under sanitizers, which are not ready when the choice is made.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define SIR_CLONES __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define SIR_CLONES
#endif
