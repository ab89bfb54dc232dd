#include "ident/likelihood/elimination/row_squares.hpp"

#include "base/kernel.hpp"
#include "ident/likelihood/rows/normal_kernels.hpp"

namespace jointid::ident {
namespace {

std::size_t square_width(Eigen::Index joint) { return widths_of(static_cast<std::size_t>(joint * (joint + 1))); }

/// conj(x_i) x_j, i ≥ j, real and imaginary parts in turn.
void put_square(const ComplexMatrix& x, Eigen::Index column, double* out) {
  const Complex* const of = x.col(column).data();
  for (Eigen::Index j = 0; j < x.rows(); ++j) {
    for (Eigen::Index i = j; i < x.rows(); ++i) {
      const Complex value = product(std::conj(of[i]), of[j]);
      *out++ = value.real();
      *out++ = value.imag();
    }
  }
}

}  // namespace

void RowSquares::add_products(const RowMatrixXd& weights, const RowMatrixXd& numbers, ComplexMatrix& out) {
  const auto count = static_cast<std::size_t>(weights.cols()), width = static_cast<std::size_t>(numbers.cols());
  sums_.setZero(weights.cols(), numbers.cols());
  ident::add_products(sums_.data(), width, {weights.data(), count}, count, {numbers.data(), width}, width,
                      static_cast<std::size_t>(weights.rows()));
  out.resize(joint_ * joint_, weights.cols());
  for (Eigen::Index k = 0; k < weights.cols(); ++k) {
    const double* from = sums_.row(k).data();
    Complex* const to = out.col(k).data();
    for (Eigen::Index j = 0; j < joint_; ++j) {
      for (Eigen::Index i = j; i < joint_; ++i, from += 2) {
        to[j + i * joint_] = {from[0], -from[1]};
        to[i + j * joint_] = {from[0], from[1]};
      }
    }
  }
}

void RowSquares::take(const LineLayout& layout, const Eigen::VectorXd& weights, const LineFactors& factors) {
  const auto others = at(layout.others);
  joint_ = at(layout.joint);
  seconds_.setZero(joint_ + others, others);
  firsts_.setZero(others, others);
  of_b_.setZero(joint_, layout.asm_jj.empty() ? 0 : joint_);
  Eigen::Index e = at(layout.variables());
  const auto next = [&] {
    const double weight = weights[e++];
    return weight * weight;
  };
  for (const auto [p, k] : layout.asm_jn) seconds_(at(p), at(k)) = next();
  for (const auto [p, q] : layout.asm_jj) of_b_(at(p), at(q)) = next();
  for (const auto [r, k] : layout.drop_nn) seconds_(joint_ + at(r), at(k)) = firsts_(at(k), at(r)) = next();
  const auto width = at(square_width(joint_));
  by_p_and_h_.setZero(joint_ + others, width);
  by_g_.setZero(others, width);
  const ComplexMatrix p_rows = factors.p.transpose();
  for (Eigen::Index p = 0; p < joint_; ++p) put_square(p_rows, p, by_p_and_h_.row(p).data());
  for (Eigen::Index k = 0; k < others; ++k) {
    put_square(factors.h, k, by_p_and_h_.row(joint_ + k).data());
    put_square(factors.za, k, by_g_.row(k).data());
  }
  add_products(seconds_, by_p_and_h_, s_);
  add_products(firsts_, by_g_, r_);
  if (of_b_.cols() > 0) add_products(of_b_, by_p_and_h_.topRows(joint_), b_);
}

}  // namespace jointid::ident
