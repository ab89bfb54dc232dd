#pragma once

#include <Eigen/Core>

#include "base/eigen.hpp"
#include "likelihood_line_sample.hpp"

namespace jointid::ident {

/// The step of the implicit problem (docs/formulas.md §11e), with every FRF of both systems as a variable and dense matrices
/// throughout:
/// conditions C = H_s − H_a − H_s Z H_a on full matrices over n + N coordinates.
class DenseStep {
 public:
  /// `state`: X, Y, A, B anywhere, not on the constraint.
  DenseStep(const LineSample& s, const LineState& state) : s_(s), n_(state.sub_jn.cols()), j_(state.sub_jn.rows()) {
    const auto size = n_ + j_;
    hs_ = ha_ = z_ = ComplexMatrix::Zero(size, size);
    hs_.bottomLeftCorner(j_, n_) = state.sub_jn;
    hs_.topRightCorner(n_, j_) = state.sub_jn.transpose();
    hs_.bottomRightCorner(j_, j_) = state.sub_jj;
    ha_.bottomLeftCorner(j_, n_) = state.asm_jn;
    if (!s.layout.asm_jj.empty()) ha_.bottomRightCorner(j_, j_) = state.asm_jj;
    z_.bottomRightCorner(j_, j_) = s.joint.at(s.theta);
    list_conditions();
    b_.resize(2 * at(rows_.size()), 0);
    add_variables(state);
    solve();
  }

  Eigen::MatrixXd information;
  Eigen::VectorXd gradient, step, frf_step;  ///< of θ; of X and Y

 private:
  using Wide = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

  /// S⁻¹ B by elimination with complete pivoting.
  static Wide solution(Wide s, Wide b) {
    const Eigen::Index n = s.rows();
    std::vector<Eigen::Index> place(std::size_t(n), 0);
    for (Eigen::Index i = 0; i < n; ++i) place[std::size_t(i)] = i;
    for (Eigen::Index k = 0; k < n; ++k) {
      Eigen::Index row = 0, column = 0;
      s.bottomRightCorner(n - k, n - k).cwiseAbs().maxCoeff(&row, &column);
      s.row(k).swap(s.row(k + row));
      b.row(k).swap(b.row(k + row));
      s.col(k).swap(s.col(k + column));
      std::swap(place[std::size_t(k)], place[std::size_t(k + column)]);
      for (Eigen::Index i = k + 1; i < n; ++i) {
        const long double factor = s(i, k) / s(k, k);
        s.row(i).tail(n - k) -= factor * s.row(k).tail(n - k);
        b.row(i) -= factor * b.row(k);
      }
    }
    Wide x(n, b.cols());
    for (Eigen::Index k = n; k-- > 0;) {
      b.row(k) /= s(k, k);
      for (Eigen::Index i = 0; i < k; ++i) b.row(i) -= s(i, k) * b.row(k);
      x.row(place[std::size_t(k)]) = b.row(k);
    }
    return x;
  }

  void list_conditions() {
    for (std::size_t i = 0; i < s_.layout.drop_nn.size(); ++i) {
      if (s_.data.drop_nn.weight[i] != Complex(0.0)) rows_.push_back(s_.layout.drop_nn[i]);
    }
    for (Eigen::Index p = 0; p < j_; ++p) {
      const auto last = s_.layout.asm_jj.empty() ? n_ : n_ + j_;
      for (Eigen::Index k = 0; k < last; ++k) rows_.push_back({std::size_t(n_ + p), std::size_t(k)});
    }
  }

  Eigen::VectorXd of_rows(const ComplexMatrix& c) const {
    Eigen::VectorXd out(2 * at(rows_.size()));
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const Complex value = c(at(rows_[i].row), at(rows_[i].column));
      out.segment<2>(2 * at(i)) << value.real(), value.imag();
    }
    return out;
  }

  /// δC of a change of one FRF in the substructures or the assembly.
  ComplexMatrix effect(const ComplexMatrix& dh, bool substructures) const {
    const ComplexMatrix one = ComplexMatrix::Identity(dh.rows(), dh.cols());
    if (substructures) return dh * (one - z_ * ha_);
    return -(one + hs_ * z_) * dh;
  }

  void add(Eigen::Index row, Eigen::Index column, bool symmetric, bool substructures, Complex weight, Complex residual, double wide) {
    for (const bool imaginary : {false, true}) {
      ComplexMatrix dh = ComplexMatrix::Zero(hs_.rows(), hs_.cols());
      dh(row, column) = imaginary ? Complex(0.0, 1.0) : Complex(1.0);
      if (symmetric) dh(column, row) = dh(row, column);
      b_.conservativeResize(Eigen::NoChange, b_.cols() + 1);
      b_.rightCols(1) = of_rows(effect(dh, substructures));
      const double w = imaginary ? weight.imag() : weight.real();
      variance_.push_back(w > 0.0 ? 1.0 / (w * w) : 0.0);
      prior_.push_back(w > 0.0 || wide == 0.0 ? 0.0 : 1.0 / (wide * wide));
      measured_minus_current_.push_back(w > 0.0 ? (imaginary ? residual.imag() : residual.real()) : 0.0);
    }
  }

  void add_variables(const LineState& state) {
    const LineLayout& layout = s_.layout;
    const double x_wide = 1e3 * state.sub_jn.cwiseAbs().maxCoeff(), y_wide = 1e3 * state.sub_jj.cwiseAbs().maxCoeff(), free = 0.0;
    for (std::size_t i = 0; i < layout.sub_jn.size(); ++i) {
      const auto r = at(layout.sub_jn[i].row), c = at(layout.sub_jn[i].column);
      add(n_ + r, c, true, true, s_.data.sub_jn.weight[i], s_.data.sub_jn.value[i] - state.sub_jn(r, c), x_wide);
    }
    for (std::size_t i = 0; i < layout.sub_jj.size(); ++i) {
      const auto r = at(layout.sub_jj[i].row), c = at(layout.sub_jj[i].column);
      add(n_ + r, n_ + c, true, true, s_.data.sub_jj.weight[i], s_.data.sub_jj.value[i] - state.sub_jj(r, c), y_wide);
    }
    for (std::size_t i = 0; i < layout.asm_jn.size(); ++i) {
      const auto r = at(layout.asm_jn[i].row), c = at(layout.asm_jn[i].column);
      add(n_ + r, c, false, false, s_.data.asm_jn.weight[i], s_.data.asm_jn.value[i] - state.asm_jn(r, c), free);
    }
    for (std::size_t i = 0; i < layout.asm_jj.size(); ++i) {
      const auto r = at(layout.asm_jj[i].row), c = at(layout.asm_jj[i].column);
      add(n_ + r, n_ + c, false, false, s_.data.asm_jj.weight[i], s_.data.asm_jj.value[i] - state.asm_jj(r, c), free);
      if (r != c) add(n_ + c, n_ + r, false, false, 0.0, 0.0, free);  // its reciprocal, as far as conditions mention it
    }
    for (std::size_t i = 0; i < layout.drop_nn.size(); ++i) {
      if (s_.data.drop_nn.weight[i] == Complex(0.0)) continue;
      add(at(layout.drop_nn[i].row), at(layout.drop_nn[i].column), false, true, s_.data.drop_nn.weight[i],
          s_.data.drop_nn.value[i], free);
    }
  }

  /// The stationary point of ½vᵀQ⁻¹v + ½fᵀPf under w + Aδθ + Ff + Bv = 0 with w = C + B(measured − current): v are the corrections
  /// of measured FRFs, f those of the others with their priors P. With S = [BQBᵀ F; Fᵀ −P] and Ā = [A; 0], w̄ = [w; 0]:
  /// N = ĀᵀS⁻¹Ā, g = −ĀᵀS⁻¹w̄, [k; −f] = S⁻¹(w̄ + Āδθ), v = −QBᵀk.
  void solve() {
    const auto unknowns = at(s_.theta.size()), conditions = b_.rows();
    std::vector<Eigen::Index> free;
    for (Eigen::Index i = 0; i < b_.cols(); ++i) {
      if (variance_[std::size_t(i)] == 0.0) free.push_back(i);
    }
    const Eigen::Map<Eigen::VectorXd> q(variance_.data(), b_.cols()), off(measured_minus_current_.data(), b_.cols());
    const Wide wide_b = b_.cast<long double>();  // weights 10⁸ apart: more digits
    const Wide spread = q.cast<long double>().asDiagonal() * wide_b.transpose();
    const auto size = conditions + at(free.size());
    Wide s = Wide::Zero(size, size), a = Wide::Zero(size, unknowns), w = Wide::Zero(size, 1);
    s.topLeftCorner(conditions, conditions) = wide_b.lazyProduct(spread);
    for (std::size_t f = 0; f < free.size(); ++f) {
      const auto place = conditions + at(f);
      s.col(place).head(conditions) = wide_b.col(free[f]);
      s.row(place).head(conditions) = wide_b.col(free[f]).transpose();
      s(place, place) = -prior_[std::size_t(free[f])];
    }
    for (Eigen::Index t = 0; t < unknowns; ++t) {
      std::vector<double> more = s_.theta;
      more[std::size_t(t)] += 1.0;
      ComplexMatrix dz = -z_;
      dz.bottomRightCorner(j_, j_) += s_.joint.at(more);
      a.col(t).head(conditions) = of_rows(-hs_ * dz * ha_).cast<long double>();
    }
    w.topRows(conditions) = of_rows(hs_ - ha_ - hs_ * z_ * ha_).cast<long double>() + wide_b.lazyProduct(off.cast<long double>());
    Wide both(size, unknowns + 1);
    both << a, w;
    const Wide solved = solution(s, both), products = a.transpose().lazyProduct(solved);
    const Wide normal = products.leftCols(unknowns), right = -products.rightCols(1);
    const Wide theta = solution(normal, right), k = solved.rightCols(1) + solved.leftCols(unknowns).lazyProduct(theta);
    information = normal.cast<double>();
    gradient = right.cast<double>();
    step = theta.cast<double>();
    Wide v = off.cast<long double>() - spread.lazyProduct(k.topRows(conditions));
    for (std::size_t f = 0; f < free.size(); ++f) v(free[f]) = -k(conditions + at(f));
    frf_step = v.cast<double>().topRows(at(2 * s_.layout.variables()));
  }

  const LineSample& s_;
  Eigen::Index n_, j_;
  ComplexMatrix hs_, ha_, z_;
  std::vector<Element> rows_;
  Eigen::MatrixXd b_;
  std::vector<double> variance_, prior_, measured_minus_current_;
};

}  // namespace jointid::ident
