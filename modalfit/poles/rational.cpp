#include "modalfit/poles/rational.hpp"

#include <algorithm>
#include <cmath>

#include "base/complex.hpp"
#include "base/eigen.hpp"
#include "dense/eigen.hpp"
#include "dense/svd.hpp"

namespace jointid::modalfit {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

constexpr std::size_t most_lines = 240, fewest_lines = 16;
constexpr double least_rank_loss = 0.6;  ///< of the smaller side, for FRFs without noise
constexpr double least_sigma = 1e-13;
constexpr double roundings = 20.0;  ///< of stored numbers that singular values may have
constexpr double farthest = 30.0;   ///< ends of the range, for a pole to be one
constexpr double least_shown = 1e-9, most_shown = 0.9;  ///< damping

struct Pencil {
  MatrixXcd values, shifted;
};

/// Both Loewner matrices of lines with values, (x, y), between those at even and at odd places.
Pencil loewner(const std::vector<Complex>& x, const std::vector<Complex>& y) {
  const auto columns = static_cast<Index>(x.size() / 2), rows = static_cast<Index>(x.size()) - columns;
  Pencil out{MatrixXcd(rows, columns), MatrixXcd(rows, columns)};
  for (Index j = 0; j < columns; ++j) {
    const std::size_t b = 2 * static_cast<std::size_t>(j) + 1;
    for (Index i = 0; i < rows; ++i) {
      const std::size_t a = 2 * static_cast<std::size_t>(i);
      out.values(i, j) = (y[a] - y[b]) / (x[a] - x[b]);
      out.shifted(i, j) = (x[a] * y[a] - x[b] * y[b]) / (x[a] - x[b]);
    }
  }
  return out;
}

/// Rows and columns of s and s* as those of real numbers: each pair times (1, 1; −i, i)/√2.
struct RealPencil {
  MatrixXd values, shifted;
};

/// The block of one line s with value v over another t with w, its conjugates included.
void fill_block(Complex s, Complex v, Complex t, Complex w, MatrixXd& values, MatrixXd& shifted, Index row, Index column) {
  const Complex same = (v - w) / (s - t), crossed = (v - std::conj(w)) / (s - std::conj(t));
  const Complex same_s = (s * v - t * w) / (s - t), crossed_s = (s * v - std::conj(t * w)) / (s - std::conj(t));
  const auto fill = [&](MatrixXd& m, Complex a, Complex b) {
    m(row, column) = a.real() + b.real();
    m(row, column + 1) = b.imag() - a.imag();
    m(row + 1, column) = a.imag() + b.imag();
    m(row + 1, column + 1) = a.real() - b.real();
  };
  fill(values, same, crossed);
  fill(shifted, same_s, crossed_s);
}

RealPencil real_loewner(const std::vector<Complex>& x, const std::vector<Complex>& y) {
  const auto columns = static_cast<Index>(x.size() / 2), rows = static_cast<Index>(x.size()) - columns;
  RealPencil out{MatrixXd(2 * rows, 2 * columns), MatrixXd(2 * rows, 2 * columns)};
  for (Index j = 0; j < columns; ++j) {
    const std::size_t b = 2 * static_cast<std::size_t>(j) + 1;
    for (Index i = 0; i < rows; ++i) {
      const std::size_t a = 2 * static_cast<std::size_t>(i);
      fill_block(x[a], y[a], x[b], y[b], out.values, out.shifted, 2 * i, 2 * j);
    }
  }
  return out;
}

/// Σ^−½ Uᴴ L' V Σ^−½ of the singular values that are not rounding; without rows where there are too many of these.
template <class Matrix>
Matrix reduced(const Matrix& values, const Matrix& shifted, double least) {
  const auto svd = dense::svd(values, dense::Vectors::thin, dense::Vectors::thin);
  const auto rank = static_cast<Index>((svd.sigma.array() > least * svd.sigma(0)).count());
  if (!(svd.sigma(0) > 0.0) || static_cast<double>(rank) > (1.0 - least_rank_loss) * static_cast<double>(svd.sigma.size())) return {};
  const Eigen::VectorXd scale = svd.sigma.head(rank).cwiseSqrt().cwiseInverse();
  return scale.asDiagonal() * (svd.u.leftCols(rank).adjoint() * shifted * svd.v.leftCols(rank)) * scale.asDiagonal();
}

/// Eigenvalues of a complex matrix and their conjugates.
Eigen::VectorXcd eigenvalues_and_conjugates(const MatrixXcd& a) {
  if (a.size() == 0) return {};
  MatrixXd real(2 * a.rows(), 2 * a.rows());
  real << a.real(), -a.imag(), a.imag(), a.real();
  return dense::eigenvalues(real);
}

/// A sum of FRFs on some lines, each over its largest modulus, times numbers without a pattern; empty where none has all lines.
std::vector<Complex> sum_of(const Band& band, const std::vector<std::size_t>& entries, const std::vector<std::size_t>& lines) {
  std::vector<Complex> sum;
  for (const std::size_t e : entries) {
    double largest = 0.0;
    for (const std::size_t l : lines) largest = band.weights(e)[2 * l] > 0.0 ? std::max(largest, std::abs(band.value(e)[l])) : HUGE_VAL;
    if (!(largest > 0.0) || !std::isfinite(largest)) continue;
    sum.resize(lines.size());
    const double factor = std::cos(1.0 + 2.399963 * static_cast<double>(e)) / largest;
    for (std::size_t i = 0; i < lines.size(); ++i) sum[i] += factor * band.value(e)[lines[i]];
  }
  return sum;
}

std::vector<std::size_t> some_lines(std::size_t all) {
  const std::size_t count = std::min(all, most_lines);
  std::vector<std::size_t> lines;
  for (std::size_t i = 0; i < count; ++i) lines.push_back(i * (all - 1) / (count - 1));
  return lines;
}

/// Viscous: of an eigenvalue iω; hysteretic: of ω². With frequency 0 where it is none.
Pole pole_of(Complex value, const ModelKind& kind) {
  const bool viscous = kind.damping == Damping::viscous;
  if (viscous) return value.imag() > 0.0 ? Pole{std::abs(value), std::abs(value.real()) / std::abs(value)} : Pole{};
  if (!(value.real() > 0.0) || value.imag() < 0.0) return {};
  return {std::sqrt(value.real()), value.imag() / value.real()};
}

}  // namespace

std::vector<Pole> rational_poles(const Band& band, const std::vector<std::size_t>& entries, const ModelKind& kind) {
  if (band.lines() < fewest_lines) return {};
  const std::vector<std::size_t> lines = some_lines(band.lines());
  const std::vector<Complex> y = sum_of(band, entries, lines);
  if (y.empty()) return {};
  std::vector<Complex> x;
  const bool viscous = kind.damping == Damping::viscous;
  for (const std::size_t l : lines) {
    const double own = band.frequency_hz[l] / band.scale_hz();
    x.push_back(viscous ? Complex(0.0, own) : Complex(own * own));
  }
  const double least = std::max(least_sigma, roundings * band.precision);
  Eigen::VectorXcd values;
  if (viscous) {
    const RealPencil pencil = real_loewner(x, y);
    if (const MatrixXd small = reduced(pencil.values, pencil.shifted, least); small.size() > 0) values = dense::eigenvalues(small);
  } else {
    const Pencil pencil = loewner(x, y);
    values = eigenvalues_and_conjugates(reduced(pencil.values, pencil.shifted, least));
  }
  std::vector<Pole> poles;
  for (const Complex value : values) {
    Pole pole = pole_of(value, kind);
    pole.frequency_hz *= band.scale_hz();
    const bool near = pole.frequency_hz > band.frequency_hz.front() / farthest && pole.frequency_hz < farthest * band.scale_hz();
    if (near && pole.damping >= least_shown && pole.damping < most_shown) poles.push_back(pole);
  }
  std::ranges::sort(poles, {}, &Pole::frequency_hz);
  return poles;
}

}  // namespace jointid::modalfit
