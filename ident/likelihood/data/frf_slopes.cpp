#include "ident/likelihood/data/frf_slopes.hpp"

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"
#include "base/kernel.hpp"
#include "base/statistics.hpp"
#include "dense/cholesky.hpp"

namespace jointid::ident {
namespace {

constexpr std::size_t most_degree = FrfSlopes::most_lines / 2;
static_assert(most_degree == 4);
using Columns = Lanes<4>;  // parts along the columns of what polynomials leave, zero beyond the degree

/// An FRF that is zero by symmetry, and rounding in it: its slope would be that of rounding, and its own size says nothing of its error.
bool is_negligible(const MeasuredFrfs& line, Element element, Complex value) {
  constexpr double negligible = 1e-12;  // of |H_rr H_cc|
  const Measured &row = line.at(element.row, element.row), &column = line.at(element.column, element.column);
  return row.known() && column.known() && std::norm(value) < negligible * std::abs(row.value * column.value);
}

/// Orthonormal columns that span what an orthogonal projector leaves, `count` of them.
Eigen::MatrixXd basis_of(Eigen::MatrixXd projector, Eigen::Index count) {
  Eigen::MatrixXd out(projector.rows(), count);
  for (Eigen::Index j = 0; j < count; ++j) {
    Eigen::Index longest = 0;
    projector.colwise().squaredNorm().maxCoeff(&longest);
    out.col(j) = projector.col(longest).normalized();
    projector -= (out.col(j) * (out.col(j).transpose() * projector)).eval();
  }
  return out;
}

/// L⁻¹ of C = L Lᵀ, by columns: what errors of these variances on the lines make of the parts along the columns. False: C is singular.
bool whitener_of(const Columns* column, std::size_t lines, const double* variance, Columns* inverse) {
  constexpr double singular = 1e-13;  // of the variance, what the columns before leave of it
  const std::size_t degree = lines / 2;
  Columns lower[most_degree] = {};
  for (std::size_t k = 0; k < lines; ++k) {
    for (std::size_t a = 0; a < degree; ++a) lower[a] += (variance[k] * column[k][a]) * column[k];
  }
  for (std::size_t a = 0; a < degree; ++a) {
    Columns row = lower[a];
    const double whole = row[a];
    for (std::size_t b = 0; b < a; ++b) row -= lower[b][a] * lower[b];
    if (!(row[a] > singular * whole)) return false;
    lower[a] = row / std::sqrt(row[a]);  // lanes before a are not used
  }
  for (std::size_t a = 0; a < degree; ++a) {
    inverse[a] = Columns{};
    for (std::size_t b = a; b < degree; ++b) {
      double sum = a == b ? 1.0 : 0.0;
      for (std::size_t c = a; c < b; ++c) sum -= lower[c][b] * inverse[a][c];
      inverse[a][b] = sum / lower[b][b];
    }
  }
  return true;
}

void whiten(const Columns* inverse, std::size_t degree, const Columns& parts, Columns& out) {
  out = Columns{};
  for (std::size_t a = 0; a < degree; ++a) out += parts[a] * inverse[a];
}

}  // namespace

/// Of the real and, after them, the imaginary parts of c_1 … c_d; the last row is that of the right side.
struct FrfSlopes::Sums {
  Columns row[2 * most_degree + 1][2 * most_degree + 1] = {};
};

/// Columns that span what polynomials leave, and w^j times them, by lines.
struct FrfSlopes::Remainder {
  Columns column[most_lines] = {}, power[most_lines][most_degree + 1] = {};
};

FrfSlopes::FrfSlopes(const std::vector<std::size_t>& coordinates, const std::vector<double>& frequency,
                     std::vector<const MeasuredFrfs*> lines, std::size_t own)
    : lines_(std::move(lines)), place_(at(lines_.size())), own_(own) {
  const Eigen::Index count = place_.size(), degree = (count - 1) / 2;
  const double unit = (frequency.back() - frequency.front()) / static_cast<double>(count - 1);
  for (Eigen::Index k = 0; k < count; ++k) place_[k] = (frequency[static_cast<std::size_t>(k)] - frequency[own]) / unit;
  Eigen::MatrixXd powers(count, degree + 1);
  for (Eigen::Index j = 0; j <= degree; ++j) powers.col(j) = place_.array().pow(static_cast<double>(j));
  const Eigen::MatrixXd inverse = dense::solve_symmetric(powers.transpose() * powers, powers.transpose());
  const Eigen::MatrixXd off = basis_of(Eigen::MatrixXd::Identity(count, count) - powers * inverse, degree);
  Remainder remainder;
  for (std::size_t k = 0; k < lines_.size(); ++k) {
    for (Eigen::Index c = 0; c < degree; ++c) remainder.column[k][static_cast<std::size_t>(c)] = off(at(k), c);
    for (Eigen::Index j = 0; j <= degree; ++j) remainder.power[k][static_cast<std::size_t>(j)] = powers(at(k), j) * remainder.column[k];
  }
  Complex rate;  // of the denominator at own, where it is 1
  Values on_lines = Values::Ones(count);
  for (int pass = 0; pass < 2; ++pass) on_lines = denominator(sums(coordinates, remainder, on_lines), rate);
  for (Eigen::Index k = 0; k < count; ++k) factor_[static_cast<std::size_t>(k)] = on_lines[k] * inverse(1, k) / unit;
  factor_[own] -= rate / unit;
}

bool FrfSlopes::take(Element element, OnLines& values) const {
  for (std::size_t k = 0; k < lines_.size(); ++k) {
    const Measured& m = lines_[k]->at(element.row, element.column);
    if (!m.known() || m.is_zero() || is_negligible(*lines_[k], element, m.value)) return false;
    values[k] = m.value;
  }
  return true;
}

/// Of the real and the imaginary part of q H on the lines; false: the errors are not known.
bool FrfSlopes::take_variances(Element element, const Values& denominator, Variances& re, Variances& im) const {
  constexpr double least = 1e-12;  // of those of all lines: parts without an error are not exact
  double all = 0.0;
  for (std::size_t k = 0; k < lines_.size(); ++k) {
    const Complex both = lines_[k]->at(element.row, element.column).variance, q = denominator[at(k)];
    const double own = q.real() * q.real(), other = q.imag() * q.imag();
    re[k] = own * both.real() + other * both.imag();
    im[k] = own * both.imag() + other * both.real();
    all += re[k] + im[k];
  }
  for (std::size_t k = 0; k < lines_.size(); ++k) {
    re[k] = std::max(re[k], least * all);
    im[k] = std::max(im[k], least * all);
  }
  return all > 0.0 && std::isfinite(all);
}

/// q = 1 + Σ c_j w^j so that q H is nearly a polynomial: what it is off is its part along the columns that polynomials leave, whitened by
/// the errors, which go through the denominator `before`. Real and imaginary parts have weights of their own: where damping is small and
/// errors are in proportion to each part, the imaginary one is known far better, and has most of what a stretch changes.
FrfSlopes::Sums FrfSlopes::sums(const std::vector<std::size_t>& coordinates, const Remainder& off, const Values& before) const {
  const std::size_t count = lines_.size(), degree = count / 2;
  OnLines values{};
  Variances variance_re{}, variance_im{};
  Sums out;
  const auto add = [&](const Columns* inverse, const Columns* own, const Columns* other, double sign) {
    Columns row[2 * most_degree + 1];
    for (std::size_t j = 1; j <= degree; ++j) {
      whiten(inverse, degree, own[j], row[j - 1]);
      whiten(inverse, degree, other[j], row[degree + j - 1]);
      row[degree + j - 1] *= sign;
    }
    whiten(inverse, degree, own[0], row[2 * degree]);
    for (std::size_t i = 0; i <= 2 * degree; ++i) {
      for (std::size_t j = 0; j <= i; ++j) out.row[i][j] += row[i] * row[j];
    }
  };
  for (std::size_t r = 0; r < coordinates.size(); ++r) {
    for (std::size_t s = 0; s <= r; ++s) {
      const Element element{coordinates[r], coordinates[s]};
      if (!take(element, values)) continue;
      if (!take_variances(element, before, variance_re, variance_im)) continue;
      Columns re[most_degree + 1] = {}, im[most_degree + 1] = {}, inverse[most_degree];
      for (std::size_t k = 0; k < count; ++k) {
        for (std::size_t j = 0; j <= degree; ++j) {
          re[j] += values[k].real() * off.power[k][j];
          im[j] += values[k].imag() * off.power[k][j];
        }
      }
      if (whitener_of(off.column, count, variance_re.data(), inverse)) add(inverse, re, im, -1.0);
      if (whitener_of(off.column, count, variance_im.data(), inverse)) add(inverse, im, re, 1.0);
    }
  }
  return out;
}

/// On the lines; a little is known of the parts of its coefficients beforehand, which are 0 ± 10.
FrfSlopes::Values FrfSlopes::denominator(const Sums& sums, Complex& rate) const {
  constexpr double beforehand = 10.0;
  const Eigen::Index degree = place_.size() / 2;
  const auto total = [&](Eigen::Index i, Eigen::Index j) {
    const Columns& parts = sums.row[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
    return (parts[0] + parts[1]) + (parts[2] + parts[3]);
  };
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(2 * degree, 2 * degree) / (beforehand * beforehand);
  Eigen::VectorXd right(2 * degree);
  for (Eigen::Index i = 0; i < 2 * degree; ++i) {
    for (Eigen::Index j = 0; j <= i; ++j) {
      matrix(i, j) += total(i, j);
      matrix(j, i) = matrix(i, j);
    }
    right[i] = -total(2 * degree, i);
  }
  const Eigen::VectorXd c = dense::solve_positive(matrix, right);
  Numbers power = Numbers::Ones(place_.size());
  Values out = Values::Ones(place_.size());
  for (Eigen::Index j = 0; j < degree; ++j) {
    power.array() *= place_.array();
    out += Complex(c[j], c[degree + j]) * power;
  }
  rate = Complex(c[0], c[degree]);
  return out;
}

Complex FrfSlopes::of(Element element) const {
  OnLines values{};
  if (!take(element, values)) return nan;
  Complex sum = 0.0;
  for (std::size_t k = 0; k < lines_.size(); ++k) sum += product(factor_[k], values[k]);
  return sum;
}

}  // namespace jointid::ident
