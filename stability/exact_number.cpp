#include "stability/exact_number.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>

namespace jointid::stability {
namespace {

template <class Scalar>
Pair<Scalar> solve(const Pair<Scalar>& z, const Pair<Scalar>& f) {
  const Eigen::Index n = z.re.rows();
  Real<Scalar> whole(2 * n, 2 * n), right(2 * n, f.re.cols());
  whole << z.re, Real<Scalar>(-z.im), z.im, z.re;
  right << f.re, f.im;
  const Real<Scalar> x = whole.partialPivLu().solve(right);
  return {x.topRows(n), x.bottomRows(n)};
}

template <class Scalar>
Real<Scalar> triangle(const Real<Scalar>& a) {
  const Eigen::HouseholderQR<Real<Scalar>> qr(a);
  return qr.matrixQR().topRows(std::min(a.rows(), a.cols())).template triangularView<Eigen::Upper>();
}

}  // namespace

template <class Scalar>
Pair<Scalar> Pair<Scalar>::operator*(const Pair& other) const {
  return {re * other.re - im * other.im, re * other.im + im * other.re};
}

template <class Scalar>
Pair<Scalar> Pair<Scalar>::operator+(const Pair& other) const {
  return {re + other.re, im + other.im};
}

template <class Scalar>
Pair<Scalar> Pair<Scalar>::operator-(const Pair& other) const {
  return {re - other.re, im - other.im};
}

template <class Scalar>
Pair<Scalar> Pair<Scalar>::adjoint() const {
  return {re.transpose(), -im.transpose()};
}

template struct Pair<Exact>;
template struct Pair<long double>;

Pair<Exact> solve_exactly(const Pair<Exact>& z, const Pair<Exact>& f) { return solve(z, f); }
Pair<long double> solve_exactly(const Pair<long double>& z, const Pair<long double>& f) { return solve(z, f); }

Real<Exact> exact_triangle(const Real<Exact>& a) { return triangle(a); }
Real<long double> exact_triangle(const Real<long double>& a) { return triangle(a); }

}  // namespace jointid::stability
