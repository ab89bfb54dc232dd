#pragma once

// Hot loops are compiled for several instruction sets and chosen at load time. They live in translation units without
// Eigen, because Debian's static Ceres is plain x86-64 and Eigen types must agree on alignment across the program.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__)
#define JOINTID_KERNEL __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define JOINTID_KERNEL
#endif
#define JOINTID_INLINE inline __attribute__((always_inline))
