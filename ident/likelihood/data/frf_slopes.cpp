#include "ident/likelihood/data/frf_slopes.hpp"

#include <array>
#include <cmath>

#include "base/eigen.hpp"
#include "base/statistics.hpp"
#include "dense/cholesky.hpp"

namespace jointid::ident {
namespace {

/// An FRF that is zero by symmetry, and rounding in it: its slope would be that of rounding, and its own size says nothing of its error.
bool is_negligible(const Symmetric<Measured>& line, Element element, Complex value) {
  constexpr double negligible = 1e-12;  // of |H_rr H_cc|
  const Measured &row = line.at(element.row, element.row), &column = line.at(element.column, element.column);
  return row.known() && column.known() && std::norm(value) < negligible * std::abs(row.value * column.value);
}

}  // namespace

FrfSlopes::FrfSlopes(const std::vector<std::size_t>& coordinates, const std::vector<double>& frequency, std::vector<const Symmetric<Measured>*> lines,
                     std::size_t own)
    : lines_(std::move(lines)), place_(at(lines_.size())) {
  const Eigen::Index count = place_.size(), degree = (count - 1) / 2;
  unit_ = (frequency.back() - frequency.front()) / static_cast<double>(count - 1);
  for (Eigen::Index k = 0; k < count; ++k) place_[k] = (frequency[static_cast<std::size_t>(k)] - frequency[own]) / unit_;
  Eigen::MatrixXd powers(count, degree + 1);
  for (Eigen::Index j = 0; j <= degree; ++j) powers.col(j) = place_.array().pow(static_cast<double>(j));
  const Eigen::MatrixXd inverse = dense::solve_symmetric(powers.transpose() * powers, powers.transpose());
  numerator_ = inverse.topRows(2);
  find_denominator(coordinates, Eigen::MatrixXd::Identity(count, count) - powers * inverse);
}

bool FrfSlopes::take(Element element, Values& values) const {
  values.resize(place_.size());
  for (std::size_t k = 0; k < lines_.size(); ++k) {
    const Measured& m = lines_[k]->at(element.row, element.column);
    if (!m.known() || m.is_zero() || is_negligible(*lines_[k], element, m.value)) return false;
    values[at(k)] = m.value;
  }
  return true;
}

/// q = 1 + Σ c_j w^j so that q H is nearly a polynomial: `across` takes what is one off.
void FrfSlopes::find_denominator(const std::vector<std::size_t>& coordinates, const Square& across) {
  const Eigen::Index count = place_.size(), degree = (count - 1) / 2;
  Eigen::MatrixXcd matrix = Eigen::MatrixXcd::Identity(degree, degree);
  Eigen::VectorXcd right = Eigen::VectorXcd::Zero(degree);
  Values values;
  std::array<Values, most> off;  // of w^j H
  for (std::size_t r = 0; r < coordinates.size(); ++r) {
    for (std::size_t s = 0; s <= r; ++s) {
      const Element element{coordinates[r], coordinates[s]};
      if (!take(element, values)) continue;
      double variance = 0.0;
      for (const Symmetric<Measured>* line : lines_) {
        const Complex both = line->at(element.row, element.column).variance;
        variance += both.real() + both.imag();
      }
      if (!(variance > 0.0)) continue;
      for (Eigen::Index j = 0; j <= degree; ++j) {
        off[static_cast<std::size_t>(j)] = across.lazyProduct(values);
        values.array() *= place_.array();
      }
      for (Eigen::Index j = 1; j <= degree; ++j) {
        const Values& own = off[static_cast<std::size_t>(j)];
        for (Eigen::Index l = 1; l <= degree; ++l) matrix(j - 1, l - 1) += own.dot(off[static_cast<std::size_t>(l)]) / variance;
        right[j - 1] -= own.dot(off[0]) / variance;
      }
    }
  }
  const Eigen::VectorXcd c = dense::solve_positive(matrix, right);
  Numbers power = Numbers::Ones(count);
  denominator_ = Values::Ones(count);
  for (Eigen::Index j = 0; j < degree; ++j) {
    power.array() *= place_.array();
    denominator_ += c[j] * power;
  }
  rate_ = c[0];
}

Complex FrfSlopes::of(Element element) const {
  Values values;
  if (!take(element, values)) return nan;
  values = values.cwiseProduct(denominator_);
  const Complex value = numerator_.row(0) * values, derivative = numerator_.row(1) * values;
  return (derivative - rate_ * value) / unit_;
}

}  // namespace jointid::ident
