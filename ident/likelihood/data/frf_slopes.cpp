#include "ident/likelihood/data/frf_slopes.hpp"

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"
#include "base/kernel.hpp"
#include "base/statistics.hpp"
#include "dense/cholesky.hpp"

namespace jointid::ident {
namespace {

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

/// What polynomials leave of the lines, as columns.
PolynomialRemainder remainder_of(const Eigen::MatrixXd& powers, const Eigen::MatrixXd& inverse) {
  const Eigen::Index count = powers.rows(), degree = powers.cols() - 1;
  const Eigen::MatrixXd off = basis_of(Eigen::MatrixXd::Identity(count, count) - powers * inverse, degree);
  PolynomialRemainder out;
  out.degree = static_cast<std::size_t>(degree);
  for (Eigen::Index k = 0; k < count; ++k) {
    for (Eigen::Index c = 0; c < degree; ++c) out.column[k][c] = off(k, c);
    for (Eigen::Index j = 0; j <= degree; ++j) out.power[k][j] = powers(k, j);
  }
  return out;
}

/// An FRF that is zero by symmetry, and rounding in it: its slope would be that of rounding, and its own size says nothing of its
/// error.
bool is_negligible(const MeasuredFrfs& line, Element element, Complex value) {
  constexpr double negligible = 1e-24;  // of |H_rr H_cc|², all as squares
  const Measured &row = line.at(element.row, element.row), &column = line.at(element.column, element.column);
  const double square = std::norm(value);
  return row.known() && column.known() && square * square < negligible * (std::norm(row.value) * std::norm(column.value));
}

}  // namespace

class FrfSlopes::Blocks {
 public:
  Blocks(std::size_t most, std::size_t lines) : lines_(lines) { blocks_.reserve((most + FrfLanes::width - 1) / FrfLanes::width); }

  void add(const Neighbours& frf) {
    double all = 0.0;
    for (std::size_t k = 0; k < lines_; ++k) all += frf[k]->variance.real() + frf[k]->variance.imag();
    if (!(all > 0.0 && std::isfinite(all))) return;
    const std::size_t lane = count_++ % FrfLanes::width;
    if (lane == 0) begin_block();
    for (std::size_t k = 0; k < lines_; ++k) {
      FrfLanes::Line& line = blocks_.back().lines[k];
      line.re[lane] = frf[k]->value.real();
      line.im[lane] = frf[k]->value.imag();
      line.variance_re[lane] = frf[k]->variance.real();
      line.variance_im[lane] = frf[k]->variance.imag();
    }
  }

  const std::vector<FrfLanes>& all() const { return blocks_; }

 private:
  void begin_block() {
    blocks_.emplace_back();
    for (FrfLanes::Line& line : blocks_.back().lines) {
      std::ranges::fill(line.variance_re, 1.0);
      std::ranges::fill(line.variance_im, 1.0);
    }
  }

  std::size_t lines_, count_ = 0;
  std::vector<FrfLanes> blocks_;
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
  const PolynomialRemainder off = remainder_of(powers, inverse);
  Neighbours frf{};
  Blocks blocks(triangle_size(coordinates.size()), lines_.size());
  for (std::size_t r = 0; r < coordinates.size(); ++r) {
    for (std::size_t s = 0; s <= r; ++s) {
      if (take({coordinates[r], coordinates[s]}, frf)) blocks.add(frf);
    }
  }
  Complex rate;  // of the denominator at own, where it is 1
  Values on_lines = Values::Ones(count);
  for (int pass = 0; pass < 2; ++pass) on_lines = denominator(blocks, off, on_lines, rate);
  for (Eigen::Index k = 0; k < count; ++k) factor_[static_cast<std::size_t>(k)] = on_lines[k] * inverse(1, k) / unit;
  factor_[own] -= rate / unit;
}

bool FrfSlopes::take(Element element, Neighbours& out) const {
  for (std::size_t k = 0; k < lines_.size(); ++k) {
    const Measured& m = lines_[k]->at(element.row, element.column);
    if (!m.known() || m.value == Complex(0.0) || is_negligible(*lines_[k], element, m.value)) return false;
    out[k] = &m;
  }
  return true;
}

/// On the lines; a little is known of the parts of its coefficients beforehand, which are 0 ± 10.
FrfSlopes::Values FrfSlopes::denominator(const Blocks& blocks, const PolynomialRemainder& off, const Values& before,
                                         Complex& rate) const {
  constexpr double beforehand = 10.0;
  const Eigen::Index degree = place_.size() / 2;
  std::array<double, triangle_size(most_lines)> sums{};
  if (before.allFinite()) add_denominator_sums(blocks.all().data(), blocks.all().size(), off, before.data(), sums.data());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(2 * degree, 2 * degree) / (beforehand * beforehand);
  Eigen::VectorXd right(2 * degree);
  const double* next = sums.data();
  for (Eigen::Index i = 0; i < 2 * degree; ++i) {
    for (Eigen::Index j = 0; j <= i; ++j) {
      matrix(i, j) += *next++;
      matrix(j, i) = matrix(i, j);
    }
  }
  for (Eigen::Index i = 0; i < 2 * degree; ++i) right[i] = -*next++;
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
  Neighbours frf{};
  if (!take(element, frf)) return nan;
  Complex sum = 0.0;
  for (std::size_t k = 0; k < lines_.size(); ++k) sum += product(factor_[k], frf[k]->value);
  return sum;
}

}  // namespace jointid::ident
