#include "ident/likelihood/elimination/normal_right_sides.hpp"

#include "base/eigen.hpp"
#include "dense/blas.hpp"

namespace jointid::ident {

void fold(const LineLayout& layout, const Complex* matrix, Complex* out) {
  const std::size_t n = layout.joint;
  for (const auto [i, j] : layout.sub_jj) *out++ += i == j ? matrix[i + i * n] : matrix[i + j * n] + matrix[j + i * n];
}

/// W² F of A and D above each other and of B, adjoint: a row for every column of A and B, side by side.
void NormalRightSides::take_given(const LineLayout& layout, const Eigen::VectorXd& squared, const RightSides& sides,
                                  bool with_differences) {
  const auto joint = at(layout.joint), others = at(layout.others), width = others + (layout.asm_jj.empty() ? 0 : joint);
  given_.setZero(width * sides.values.cols(), joint + (with_differences ? others : 0));
  for (Eigen::Index s = 0; s < sides.values.cols(); ++s) {
    Eigen::Index e = at(layout.variables());
    const auto put = [&](Eigen::Index column, Eigen::Index row) {
      given_(s * width + column, row) = squared[e] * std::conj(sides.values(e, s));
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
  const auto joint = at(layout.joint), others = at(layout.others), count = sides.values.cols();
  const Eigen::Index width = others + (layout.asm_jj.empty() ? 0 : joint), x = at(layout.sub_jn.size()), v = at(layout.variables());
  const Eigen::VectorXd squared = weights.all.cwiseAbs2();
  const Eigen::Index used = sides.values.rows() - (with_differences ? 0 : at(layout.drop_nn.size()));
  weighed_ = (weights.all.head(used).asDiagonal() * sides.values.topRows(used)).adjoint();
  square_.setZero(count, count);
  dense::add_square(weighed_, square_);
  values_ = squared.head(v).asDiagonal() * sides.values.topRows(v);
  take_given(layout, squared, sides, with_differences);
  left_.resize(joint, given_.cols());
  left_.leftCols(joint) = factors.p.adjoint();
  if (with_differences) left_.rightCols(others) = factors.h.conjugate();
  told_.setZero(joint, width * count);
  dense::add_product(left_, given_, told_);
  by_.resize(joint, width);
  by_.leftCols(others) = -factors.za;
  if (!layout.asm_jj.empty()) by_.rightCols(joint) = factors.c;
  of_y_.resize(joint, joint);
  for (Eigen::Index s = 0; s < count; ++s) {
    of_y_.setZero();
    dense::add_product(told_.middleCols(s * width, width), by_, of_y_);
    fold(layout, of_y_.data(), values_.col(s).data() + x);
    for (Eigen::Index i = 0; i < x; ++i) {
      const auto [p, k] = layout.sub_jn[static_cast<std::size_t>(i)];
      values_(i, s) += told_(at(p), s * width + at(k));
    }
  }
  if (with_differences && !layout.drop_nn.empty()) add_by_second(layout, squared, sides, factors);
}

/// conj(G) (W_D² F_D)ᵀ.
void NormalRightSides::add_by_second(const LineLayout& layout, const Eigen::VectorXd& squared, const RightSides& sides,
                                     const LineFactors& factors) {
  const auto joint = at(layout.joint), others = at(layout.others), count = sides.values.cols(), d = at(layout.drop_nn.size());
  const Eigen::Index first = sides.values.rows() - d;
  given_.setZero(others * count, others);
  for (Eigen::Index s = 0; s < count; ++s) {
    for (Eigen::Index i = 0; i < d; ++i) {
      const auto [r, k] = layout.drop_nn[static_cast<std::size_t>(i)];
      given_(s * others + at(r), at(k)) = squared[first + i] * std::conj(sides.values(first + i, s));
    }
  }
  left_ = factors.za.conjugate();
  told_.setZero(joint, others * count);
  dense::add_product(left_, given_, told_);
  for (Eigen::Index s = 0; s < count; ++s) {
    for (std::size_t i = 0; i < layout.sub_jn.size(); ++i)
      values_(at(i), s) += told_(at(layout.sub_jn[i].row), s * others + at(layout.sub_jn[i].column));
  }
}

}  // namespace jointid::ident
