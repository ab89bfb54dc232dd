#pragma once

#include <complex>

// Hot loops are compiled for several instruction sets and chosen at load time. They live in translation units without
// Eigen, because Debian's static Ceres is plain x86-64 and Eigen types must agree on alignment across the program.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__)
#define JOINTID_KERNEL __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define JOINTID_KERNEL
#endif
#define JOINTID_INLINE inline __attribute__((always_inline))

namespace jointid {

/// a b without the look of std::complex at whether an infinite factor made the product no number.
JOINTID_INLINE std::complex<double> product(const std::complex<double>& a, const std::complex<double>& b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

}  // namespace jointid
