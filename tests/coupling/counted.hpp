#pragma once

#include <Eigen/Core>
#include <complex>
#include <cstddef>

namespace jointid::coupling {

/// A complex number that counts multiplications and divisions.
struct Counted {
  std::complex<double> value;
  static inline std::size_t multiplications = 0;

  Counted(double re = 0.0) : value(re) {}  // NOLINT(google-explicit-constructor): as Eigen takes numbers
  Counted(std::complex<double> z) : value(z) {}  // NOLINT(google-explicit-constructor)

  Counted& operator+=(const Counted& o) { value += o.value; return *this; }
  Counted& operator-=(const Counted& o) { value -= o.value; return *this; }
  Counted& operator*=(const Counted& o) { ++multiplications; value *= o.value; return *this; }
  Counted& operator/=(const Counted& o) { ++multiplications; value /= o.value; return *this; }
  friend Counted operator+(Counted a, const Counted& b) { return a += b; }
  friend Counted operator-(Counted a, const Counted& b) { return a -= b; }
  friend Counted operator*(Counted a, const Counted& b) { return a *= b; }
  friend Counted operator/(Counted a, const Counted& b) { return a /= b; }
  friend Counted operator-(const Counted& a) { return Counted(-a.value); }
  friend bool operator==(const Counted& a, const Counted& b) { return a.value == b.value; }
  friend bool operator!=(const Counted& a, const Counted& b) { return a.value != b.value; }
};

}  // namespace jointid::coupling

template <>
struct Eigen::NumTraits<jointid::coupling::Counted> : Eigen::GenericNumTraits<jointid::coupling::Counted> {
  using Real = jointid::coupling::Counted;
  using NonInteger = jointid::coupling::Counted;
  using Nested = jointid::coupling::Counted;
  using Literal = double;
  enum { IsComplex = 0, IsInteger = 0, IsSigned = 1, RequireInitialization = 1, ReadCost = 2, AddCost = 2, MulCost = 6 };
};
