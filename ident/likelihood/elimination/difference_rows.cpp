#include "ident/likelihood/elimination/difference_rows.hpp"

#include <algorithm>

#include "base/eigen.hpp"
#include "base/kernel.hpp"
#include "dense/blas.hpp"

namespace jointid::ident {
namespace {

/// Conjugates of lᵀ δY g by the elements of Y.
void add_conjugates(const LineLayout& layout, const Complex* l, const Complex* g, Complex* out) {
  for (const auto [i, j] : layout.sub_jj) {
    *out++ += std::conj(i == j ? product(l[i], g[i]) : product(l[i], g[j]) + product(l[j], g[i]));
  }
}

}  // namespace

DifferenceRows::DifferenceRows(const LineLayout& layout)
    : layout_(layout), at_row_(layout.others * layout.others), touch_(layout.others), half_(layout.others) {}

void DifferenceRows::take(const LineData& data, const LineFactors& factors) {
  const std::size_t n = layout_.others;
  rows_.clear();
  std::ranges::fill(at_row_, -1);
  for (std::size_t i = 0; i < layout_.drop_nn.size(); ++i) {
    if (data.drop_nn.weight[i] == Complex(0.0)) continue;
    const auto [r, k] = layout_.drop_nn[i];
    at_row_[r + k * n] = at_row_[k + r * n] = size();
    rows_.push_back({i, r, k});
  }
  weights_.resize(size());
  for (std::size_t i = 0; i < rows_.size(); ++i) weights_[at(i)] = data.drop_nn.weight[rows_[i].element].real();
  g_ = factors.za;
  h_ = factors.h;
}

bool DifferenceRows::factor(const EliminatedColumns& columns, const ComplexMatrix& lower) {
  if (rows_.empty()) return true;
  const auto n = at(layout_.others);
  std::vector<ComplexMatrix> by_y(layout_.others);  // touch_ᵀ M⁻¹ S, transposed
  lower_ = ComplexMatrix::Identity(size(), size());
  for (Eigen::Index k = 0; k < n; ++k) {
    const auto c = static_cast<std::size_t>(k);
    const EliminatedColumns::Column& column = columns.columns()[c];
    ComplexMatrix along(g_.rows(), n);
    along << h_.leftCols(k), g_.col(k) + h_.col(k), g_.rightCols(n - k - 1);
    touch_[c] = columns.rows_of(c, along);
    half_[c] = touch_[c].conjugate();
    if (column.count > 0) dense::solve_lower(column.lower, half_[c]);
    by_y[c].noalias() = column.answer.transpose() * touch_[c];
    const ComplexMatrix squares = half_[c].adjoint() * half_[c];
    for (Eigen::Index j = 0; j < n; ++j) {
      const Eigen::Index second = at_row_[static_cast<std::size_t>(k * n + j)];
      for (Eigen::Index i = 0; second >= 0 && i < n; ++i) {
        const Eigen::Index first = at_row_[static_cast<std::size_t>(k * n + i)];
        if (first >= second) lower_(first, second) += weights_[first] * weights_[second] * squares(i, j);
      }
    }
  }
  towards_y_.setZero(at(layout_.sub_jj.size()), size());
  Eigen::VectorXcd left;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const auto [element, r, k] = rows_[i];
    Complex* const out = towards_y_.col(at(i)).data();
    left = by_y[k].col(at(r)) - h_.col(at(r));
    add_conjugates(layout_, left.data(), g_.col(at(k)).data(), out);
    if (r != k) add_conjugates(layout_, by_y[r].col(at(k)).data(), g_.col(at(r)).data(), out);
  }
  dense::solve_lower(lower, towards_y_);
  weighed_ = weights_.asDiagonal() * towards_y_.adjoint();
  dense::add_square(weighed_, lower_);
  constexpr double most = 1e6;  // variance of D as all else predicts it, over its own: that costs as many digits
  if (!(lower_.diagonal().real().maxCoeff() <= most)) return false;
  return dense::cholesky_in_place(lower_);
}

ComplexMatrix DifferenceRows::pick(const Eigen::Ref<const ComplexMatrix>& all) const {
  ComplexMatrix out(size(), all.cols());
  for (std::size_t i = 0; i < rows_.size(); ++i) out.row(at(i)) = all.row(at(rows_[i].element));
  return out;
}

void DifferenceRows::answer(const EliminatedColumns& columns, const ComplexMatrix& x, const ComplexMatrix& y, ComplexMatrix& f,
                            ComplexMatrix& square) const {
  const std::size_t n = layout_.others;
  for (std::size_t k = 0; k < n; ++k) {
    const EliminatedColumns::Column& column = columns.columns()[k];
    const ComplexMatrix off = touch_[k].transpose() * x.middleRows(column.first, column.count);
    for (std::size_t m = 0; m < n; ++m) {
      if (const Eigen::Index row = at_row_[k * n + m]; row >= 0) f.row(row) -= off.row(at(m));
    }
  }
  ComplexMatrix by_y = ComplexMatrix::Zero(f.rows(), f.cols());
  dense::add_product(weighed_, y.adjoint().eval(), by_y);
  f = weights_.asDiagonal() * f - by_y;
  dense::solve_lower(lower_, f);
  dense::add_square(f.adjoint().eval(), square);
  dense::solve_lower_adjoint(lower_, f);
  f = weights_.asDiagonal() * f;
}

void DifferenceRows::add_forces(const EliminatedColumns& columns, const ComplexMatrix& s, ComplexMatrix& x,
                                ComplexMatrix& y) const {
  dense::add_product(towards_y_, s.adjoint().eval(), y);
  const std::size_t n = layout_.others;
  ComplexMatrix of_column(at(n), s.cols());
  for (std::size_t k = 0; k < n; ++k) {
    const EliminatedColumns::Column& column = columns.columns()[k];
    if (column.count == 0) continue;
    for (std::size_t m = 0; m < n; ++m) {
      const Eigen::Index row = at_row_[k * n + m];
      of_column.row(at(m)) = row >= 0 ? ComplexMatrix(s.row(row)) : ComplexMatrix::Zero(1, s.cols());
    }
    ComplexMatrix step = half_[k] * of_column;
    dense::solve_lower_adjoint(column.lower, step);
    x.middleRows(column.first, column.count) += step;
  }
}

}  // namespace jointid::ident
