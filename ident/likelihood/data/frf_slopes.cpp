#include "ident/likelihood/data/frf_slopes.hpp"

#include <cmath>

#include "base/eigen.hpp"
#include "base/kernel.hpp"
#include "base/statistics.hpp"
#include "dense/cholesky.hpp"

namespace jointid::ident {
namespace {

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

}  // namespace

FrfSlopes::FrfSlopes(const std::vector<std::size_t>& coordinates, const std::vector<double>& frequency,
                     std::vector<const MeasuredFrfs*> lines, std::size_t own)
    : lines_(std::move(lines)), place_(at(lines_.size())), own_(own) {
  const Eigen::Index count = place_.size(), degree = (count - 1) / 2;
  const double unit = (frequency.back() - frequency.front()) / static_cast<double>(count - 1);
  for (Eigen::Index k = 0; k < count; ++k) place_[k] = (frequency[static_cast<std::size_t>(k)] - frequency[own]) / unit;
  Eigen::MatrixXd powers(count, degree + 1);
  for (Eigen::Index j = 0; j <= degree; ++j) powers.col(j) = place_.array().pow(static_cast<double>(j));
  const Eigen::MatrixXd inverse = dense::solve_symmetric(powers.transpose() * powers, powers.transpose());
  Complex rate;  // of the denominator at own, where it is 1
  const Values on_lines =
      denominator(sums(coordinates, basis_of(Eigen::MatrixXd::Identity(count, count) - powers * inverse, degree)), rate);
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

/// Of all lines.
double FrfSlopes::variance(Element element) const {
  double sum = 0.0;
  for (const MeasuredFrfs* line : lines_) {
    const Complex both = line->at(element.row, element.column).variance;
    sum += both.real() + both.imag();
  }
  return sum;
}

/// q = 1 + Σ c_j w^j so that q H is nearly a polynomial: what it is off is its part along the columns of `off`.
FrfSlopes::Sums FrfSlopes::sums(const std::vector<std::size_t>& coordinates, const Square& off) const {
  static_assert(most_degree == 4);
  const std::size_t count = lines_.size(), degree = count / 2;
  Columns factor[most_lines][most_degree + 1] = {};  // what w^j H on a line adds to its parts along the columns
  for (std::size_t k = 0; k < count; ++k) {
    double power = 1.0;
    for (std::size_t j = 0; j <= degree; ++j, power *= place_[at(k)]) {
      for (std::size_t c = 0; c < degree; ++c) factor[k][j][c] = off(at(k), at(c)) * power;
    }
  }
  OnLines values{};
  Columns sum_re[most_degree + 1][most_degree] = {}, sum_im[most_degree + 1][most_degree] = {};
  for (std::size_t r = 0; r < coordinates.size(); ++r) {
    for (std::size_t s = 0; s <= r; ++s) {
      const Element element{coordinates[r], coordinates[s]};
      if (!take(element, values)) continue;
      const double variance = this->variance(element);
      if (!(variance > 0.0)) continue;
      Columns re[most_degree + 1] = {}, im[most_degree + 1] = {};
      for (std::size_t k = 0; k < count; ++k) {
        for (std::size_t j = 0; j <= degree; ++j) {
          re[j] += values[k].real() * factor[k][j];
          im[j] += values[k].imag() * factor[k][j];
        }
      }
      const double weight = 1.0 / variance;
      for (std::size_t i = 0; i <= degree; ++i) {
        for (std::size_t j = 1; j <= degree; ++j) {
          sum_re[i][j - 1] += weight * (re[j] * re[i] + im[j] * im[i]);
          sum_im[i][j - 1] += weight * (re[j] * im[i] - im[j] * re[i]);
        }
      }
    }
  }
  Sums out;
  const auto total = [&](std::size_t i, std::size_t j) {
    const Columns re = sum_re[i][j], im = sum_im[i][j];
    return Complex((re[0] + re[1]) + (re[2] + re[3]), (im[0] + im[1]) + (im[2] + im[3]));
  };
  for (std::size_t j = 0; j < degree; ++j) {
    for (std::size_t l = 0; l < degree; ++l) out.matrix[j][l] = total(l + 1, j);
    out.right[j] = -total(0, j);
  }
  return out;
}

/// On the lines; a little is known of its coefficients beforehand, which are 0 ± 1.
FrfSlopes::Values FrfSlopes::denominator(const Sums& sums, Complex& rate) const {
  const Eigen::Index degree = place_.size() / 2;
  Eigen::MatrixXcd matrix = Eigen::MatrixXcd::Identity(degree, degree);
  Eigen::VectorXcd right(degree);
  for (Eigen::Index j = 0; j < degree; ++j) {
    const auto row = static_cast<std::size_t>(j);
    for (Eigen::Index l = 0; l < degree; ++l) matrix(j, l) += sums.matrix[row][static_cast<std::size_t>(l)];
    right[j] = sums.right[row];
  }
  const Eigen::VectorXcd c = dense::solve_positive(matrix, right);
  Numbers power = Numbers::Ones(place_.size());
  Values out = Values::Ones(place_.size());
  for (Eigen::Index j = 0; j < degree; ++j) {
    power.array() *= place_.array();
    out += c[j] * power;
  }
  rate = c[0];
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
