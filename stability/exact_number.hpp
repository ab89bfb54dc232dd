#pragma once

#include <Eigen/Core>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>

/// 50-digit arithmetic, for the files that need it: everything here is slow to compile.
namespace jointid::stability {

using Exact = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

template <class Scalar>
using Real = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

/// A complex matrix as two real ones: std::complex is not made for other numbers than the built-in ones.
template <class Scalar>
struct Pair {
  Real<Scalar> re, im;

  Pair() = default;
  Pair(Eigen::Index rows, Eigen::Index columns) : re(Real<Scalar>::Zero(rows, columns)), im(re) {}
  Pair(Real<Scalar> real, Real<Scalar> imaginary) : re(std::move(real)), im(std::move(imaginary)) {}

  Pair operator*(const Pair& other) const;
  Pair operator+(const Pair& other) const;
  Pair operator-(const Pair& other) const;
  Pair adjoint() const;
};
extern template struct Pair<Exact>;
extern template struct Pair<long double>;

/// Z⁻¹F, from the real system [Re Z, −Im Z; Im Z, Re Z].
Pair<Exact> solve_exactly(const Pair<Exact>& z, const Pair<Exact>& f);
Pair<long double> solve_exactly(const Pair<long double>& z, const Pair<long double>& f);

/// R of A = QR, min(rows, columns) × columns, by Householder reflections without pivoting.
Real<Exact> exact_triangle(const Real<Exact>& a);
Real<long double> exact_triangle(const Real<long double>& a);

}  // namespace jointid::stability
