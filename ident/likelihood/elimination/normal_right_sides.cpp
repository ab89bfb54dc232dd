#include "ident/likelihood/elimination/normal_right_sides.hpp"

#include <algorithm>

#include "base/eigen.hpp"
#include "base/kernel.hpp"
#include "dense/blas.hpp"

namespace jointid::ident {

void fold(const LineLayout& layout, const Complex* matrix, Complex* out) {
  const std::size_t n = layout.joint;
  for (const auto [i, j] : layout.sub_jj) *out++ += i == j ? matrix[i + i * n] : matrix[i + j * n] + matrix[j + i * n];
}

/// W² F of A and D above each other and of B, adjoint: a row for every column of A and B, side by side.
void NormalRightSides::take_given(const LineLayout& layout, const Eigen::VectorXd& squared, const Sides& sides, bool with_differences) {
  const auto joint = at(layout.joint), others = at(layout.others), width = others + (layout.asm_jj.empty() ? 0 : joint);
  given_.setZero(width * sides.cols(), joint + (with_differences ? others : 0));
  for (Eigen::Index s = 0; s < sides.cols(); ++s) {
    Eigen::Index e = at(layout.variables());
    const auto put = [&](Eigen::Index column, Eigen::Index row) {
      given_(s * width + column, row) = squared[e] * std::conj(sides(e, s));
      ++e;
    };
    for (const auto [p, k] : layout.asm_jn) put(at(k), at(p));
    for (const auto [p, q] : layout.asm_jj) put(others + at(q), at(p));
    for (std::size_t i = 0; with_differences && i < layout.drop_nn.size(); ++i)
      put(at(layout.drop_nn[i].column), joint + at(layout.drop_nn[i].row));
  }
}

void NormalRightSides::take(const LineLayout& layout, const ElementWeights& weights, const RightSides& sides, const LineFactors& factors,
                            bool with_differences) {
  constexpr Eigen::Index most_sides = 8;  // at once: what is made of them stays in the cache
  const auto joint = at(layout.joint), others = at(layout.others), count = sides.values.cols(), v = at(layout.variables());
  squared_ = weights.all.cwiseAbs2();
  take_square(sides, sides.values.rows() - (with_differences ? 0 : at(layout.drop_nn.size())));
  values_ = squared_.head(v).asDiagonal() * sides.values.topRows(v);
  left_.resize(joint, joint + (with_differences ? others : 0));
  left_.leftCols(joint) = factors.p.adjoint();
  if (with_differences) left_.rightCols(others) = factors.h.conjugate();
  second_left_ = factors.za.conjugate();
  by_.resize(joint, others + (layout.asm_jj.empty() ? 0 : joint));
  by_.leftCols(others) = -factors.za;
  if (!layout.asm_jj.empty()) by_.rightCols(joint) = factors.c;
  for (Eigen::Index first = 0; first < count; first += most_sides) {
    const Eigen::Index some = std::min(most_sides, count - first);
    const Sides of = sides.values.middleCols(first, some);
    take_given(layout, squared_, of, with_differences);
    add_given(layout, values_.middleCols(first, some));
    if (with_differences && !layout.drop_nn.empty()) add_by_second(layout, squared_, of, values_.middleCols(first, some));
  }
}

void NormalRightSides::add_given(const LineLayout& layout, Eigen::Ref<ComplexMatrix> out) {
  const auto joint = at(layout.joint), width = by_.cols(), x = at(layout.sub_jn.size());
  told_.setZero(joint, given_.rows());
  dense::add_product(left_, given_, told_);
  of_y_.resize(joint, joint);
  for (Eigen::Index s = 0; s < out.cols(); ++s) {
    of_y_.setZero();
    dense::add_product(told_.middleCols(s * width, width), by_, of_y_);
    fold(layout, of_y_.data(), out.col(s).data() + x);
    for (Eigen::Index i = 0; i < x; ++i) {
      const auto [p, k] = layout.sub_jn[static_cast<std::size_t>(i)];
      out(i, s) += told_(at(p), s * width + at(k));
    }
  }
}

/// conj(G) (W_D² F_D)ᵀ.
void NormalRightSides::add_by_second(const LineLayout& layout, const Eigen::VectorXd& squared, const Sides& sides,
                                     Eigen::Ref<ComplexMatrix> out) {
  const auto joint = at(layout.joint), others = at(layout.others), d = at(layout.drop_nn.size());
  const Eigen::Index first = sides.rows() - d;
  given_.setZero(others * sides.cols(), others);
  for (Eigen::Index s = 0; s < sides.cols(); ++s) {
    for (Eigen::Index i = 0; i < d; ++i) {
      const auto [r, k] = layout.drop_nn[static_cast<std::size_t>(i)];
      given_(s * others + at(r), at(k)) = squared[first + i] * std::conj(sides(first + i, s));
    }
  }
  told_.setZero(joint, given_.rows());
  dense::add_product(second_left_, given_, told_);
  for (Eigen::Index s = 0; s < sides.cols(); ++s) {
    for (std::size_t i = 0; i < layout.sub_jn.size(); ++i)
      out(at(i), s) += told_(at(layout.sub_jn[i].row), s * others + at(layout.sub_jn[i].column));
  }
}

/// Fᴴ W² F of the first `used` elements. Systematic errors have few elements each: an element adds the products of those that it has.
void NormalRightSides::take_square(const RightSides& sides, Eigen::Index used) {
  const Eigen::Index count = sides.values.cols(), errors = sides.errors, first = sides.first_error;
  square_.setZero(count, count);
  weighed_ = squared_.head(used).cwiseSqrt().asDiagonal() * sides.values.topRows(used);
  if (errors == 0) {
    dense::add_square(weighed_.adjoint(), square_);
    return;
  }
  ComplexMatrix few(used, count - errors);
  few << weighed_.leftCols(first), weighed_.rightCols(1);
  ComplexMatrix of_few = ComplexMatrix::Zero(few.cols(), few.cols());
  dense::add_square(few.adjoint(), of_few);
  square_.topLeftCorner(first, first) = of_few.topLeftCorner(first, first);
  square_.bottomLeftCorner(1, first) = of_few.bottomLeftCorner(1, first);
  square_(count - 1, count - 1) = of_few(first, first);
  std::vector<Eigen::Index> has;
  for (Eigen::Index e = 0; e < used; ++e) {
    has.clear();
    for (Eigen::Index u = first; u < first + errors; ++u) {
      if (weighed_(e, u) != Complex(0.0)) has.push_back(u);
    }
    for (const Eigen::Index u : has) {
      for (Eigen::Index s = 0; s < first; ++s) square_(u, s) += conjugate_product(weighed_(e, u), weighed_(e, s));
      for (const Eigen::Index other : has) {
        if (other <= u) square_(u, other) += conjugate_product(weighed_(e, u), weighed_(e, other));
      }
      square_(count - 1, u) += conjugate_product(weighed_(e, count - 1), weighed_(e, u));
    }
  }
}

}  // namespace jointid::ident
