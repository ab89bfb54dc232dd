#pragma once

#include <complex>
#include <cstddef>
#include <cstring>

// Hot loops are compiled for several instruction sets, and chosen on the machine that runs them. They live in translation units
// without Eigen, because Debian's static Ceres is plain x86-64 and Eigen types must agree on alignment across the program.
//
// JOINTID_KERNEL_OF_LANES(void add, (double* x), add_lanes, (x)) defines a kernel by a template that takes the lanes of a
// register. GCC keeps wider vectors than a register in memory, which costs up to six times the time; narrower ones leave half of
// it empty.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__)
#define JOINTID_KERNEL __attribute__((target_clones("default", "arch=x86-64-v3", "avx512f")))
#define JOINTID_KERNEL_OF_LANES(result_and_name, parameters, body, arguments)                                                     \
  namespace {                                                                                                                   \
  __attribute__((target("arch=x86-64-v3"))) auto body##_of_4 parameters { return body<4> arguments; }                           \
  __attribute__((target("avx512f"))) auto body##_of_8 parameters { return body<8> arguments; }                                  \
  }                                                                                                                             \
  result_and_name parameters {                                                                                                  \
    const std::size_t lanes = lanes_of_machine();                                                                               \
    return lanes == 8 ? body##_of_8 arguments : lanes == 4 ? body##_of_4 arguments : body<2> arguments;                         \
  }

namespace jointid {

/// Numbers in a register of this machine.
inline std::size_t lanes_of_machine() {
  static const std::size_t lanes = []() -> std::size_t {
    __builtin_cpu_init();
    return __builtin_cpu_supports("avx512f") ? 8U : __builtin_cpu_supports("x86-64-v3") ? 4U : 2U;
  }();
  return lanes;
}

}  // namespace jointid
#else
#define JOINTID_KERNEL
#define JOINTID_KERNEL_OF_LANES(result_and_name, parameters, body, arguments) \
  result_and_name parameters { return body<2> arguments; }
#endif
#define JOINTID_INLINE inline __attribute__((always_inline))

namespace jointid {

/// So many numbers as one.
template <std::size_t count>
struct LanesOf {
  typedef double type __attribute__((vector_size(count * sizeof(double))));
};
template <std::size_t count>
using Lanes = typename LanesOf<count>::type;

template <class Vector>
JOINTID_INLINE void load(const double* from, Vector& to) {
  std::memcpy(&to, from, sizeof(Vector));
}

template <class Vector>
JOINTID_INLINE void store(const Vector& from, double* to) {
  std::memcpy(to, &from, sizeof(Vector));
}

/// a b without the look of std::complex at whether an infinite factor made the product no number.
JOINTID_INLINE std::complex<double> product(const std::complex<double>& a, const std::complex<double>& b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

/// ā b, likewise.
JOINTID_INLINE std::complex<double> conjugate_product(const std::complex<double>& a, const std::complex<double>& b) {
  return {a.real() * b.real() + a.imag() * b.imag(), a.real() * b.imag() - a.imag() * b.real()};
}

}  // namespace jointid
