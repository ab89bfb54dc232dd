#include "coupling/error_sums.hpp"

#include <cmath>
#include <map>

#include "base/eigen.hpp"
#include "dense/blas.hpp"
#include "dense/cholesky.hpp"

namespace jointid::coupling {
namespace {

using Terms = std::vector<frf::ErrorSums::Term>;

/// The errors of the FRFs of H as sums of independent ones.
class PartErrors {
 public:
  PartErrors(const MatrixRef& h, const LineVariance& variance, Index connected, const std::vector<Index>& twin)
      : h_(h), rows_(h.rows()), connected_(connected), twin_(twin), terms_(static_cast<std::size_t>(h.size())) {
    const RealMatrix plus = variance.real + variance.imaginary, minus = variance.real - variance.imaginary;
    for (const SharedColumns& shared : variance.shared) add_shared(variance, shared);
    for (Index l = 0; l < h.cols(); ++l) {
      const bool shared = !variance.covariance.empty() && !variance.covariance[static_cast<std::size_t>(l)].isZero(0.0);
      shared ? add_column(l, plus.col(l), variance.covariance[static_cast<std::size_t>(l)]) : add_independent(l, plus.col(l), minus.col(l));
    }
  }

  const Terms& of(Index row, Index column) const { return terms_[static_cast<std::size_t>(column * rows_ + row)]; }
  std::size_t count() const { return count_; }

 private:
  Terms& at(Index row, Index column) { return terms_[static_cast<std::size_t>(column * rows_ + row)]; }

  /// The row and the column of the same coordinate; −1: none.
  Index row_of(Index column) const {
    if (column < connected_) return column;
    for (std::size_t k = 0; k < twin_.size(); ++k) {
      if (twin_[k] == column) return connected_ + jointid::at(k);
    }
    return -1;
  }
  Index column_of(Index row) const { return row < connected_ ? row : twin_[static_cast<std::size_t>(row - connected_)]; }

  /// Errors of columns that have something in common, e_l = K_l Σ_m W_lm ε_m with ρ = W Wᴴ.
  void add_shared(const LineVariance& variance, const SharedColumns& columns) {
    const ComplexMatrix between = dense::semidefinite_cholesky(columns.correlation);
    const std::size_t size = columns.rows.size();
    for (Index l = 0; l < between.rows(); ++l) {
      const Index column = columns.columns[static_cast<std::size_t>(l)];
      const ComplexMatrix own = covariance_factor(variance, columns.rows, column);
      for (Index i = 0; i < own.rows(); ++i) {
        for (Index m = 0; m <= l; ++m) {
          for (Index k = 0; k <= i; ++k) {
            const Complex factor = own(i, k) * between(l, m);
            if (factor == Complex(0.0)) continue;
            at(columns.rows[static_cast<std::size_t>(i)], column)
                .push_back({count_ + static_cast<std::size_t>(m) * size + static_cast<std::size_t>(k), factor});
          }
        }
      }
    }
    count_ += columns.columns.size() * size;
  }

  /// `difference`: of the variances of real and imaginary part, whose errors are independent.
  void add_independent(Index l, const Eigen::VectorXd& variance, const Eigen::VectorXd& difference) {
    for (Index k = 0; k < rows_; ++k) {
      if (!(variance[k] > 0.0) || !std::isfinite(variance[k]) || !at(k, l).empty()) continue;
      const Index back_row = row_of(l), back_column = column_of(k);
      const bool has_back = back_row >= 0 && back_column >= 0 && back_column < l && !of(back_row, back_column).empty();
      if (has_back && is_one_measurement(h_(k, l), h_(back_row, back_column))) {
        at(k, l) = of(back_row, back_column);
      } else {
        at(k, l) = {{count_++, std::sqrt(variance[k]), difference[k] / variance[k]}};
      }
    }
  }

  /// With C = D (ρ + 1e-9) D; where that has no factor the errors are taken for independent.
  void add_column(Index l, const Eigen::VectorXd& variance, const ComplexMatrix& covariance) {
    std::vector<Index> some;
    for (Index k = 0; k < rows_; ++k) {
      if (variance[k] > 0.0 && std::isfinite(variance[k]) && at(k, l).empty()) some.push_back(k);
    }
    if (some.empty()) return;
    const Eigen::VectorXd size = variance(some).cwiseSqrt();
    ComplexMatrix factor = size.cwiseInverse().asDiagonal() * covariance(some, some) * size.cwiseInverse().asDiagonal();
    factor.diagonal().setConstant(1.0 + 1e-9);
    if (!dense::cholesky_in_place(factor)) return add_independent(l, variance, Eigen::VectorXd::Zero(rows_));
    for (Index i = 0; i < factor.rows(); ++i) {
      for (Index m = 0; m <= i; ++m) {
        at(some[static_cast<std::size_t>(i)], l).push_back({count_ + static_cast<std::size_t>(m), size[i] * factor(i, m)});
      }
    }
    count_ += some.size();
  }

  const MatrixRef& h_;
  Index rows_, connected_;
  const std::vector<Index>& twin_;
  std::size_t count_ = 0;
  std::vector<Terms> terms_;
};

/// The coordinates that a row of L or a column of R has factors for: the connected ones, and its own.
template <class Factors>
std::vector<std::pair<Index, Complex>> factors_of(const Factors& connected, Index own) {
  std::vector<std::pair<Index, Complex>> out;
  for (Index i = 0; i < connected.size(); ++i) {
    if (connected[i] != Complex(0.0)) out.emplace_back(i, connected[i]);
  }
  if (own >= connected.size()) out.emplace_back(own, 1.0);
  return out;
}

}  // namespace

frf::ErrorSums error_sums(const Sensitivity& sensitivity, const MatrixRef& h, const LineVariance& variance, const Wanted& wanted,
                          const std::vector<Index>& twin) {
  const PartErrors parts(h, variance, sensitivity.left.cols(), twin);
  frf::ErrorSums out{.errors = parts.count(), .terms = {}};
  for (std::size_t r = 0; r < wanted.rows.size(); ++r) {
    const auto left = factors_of(sensitivity.left.row(at(r)), wanted.rows[r]);
    for (std::size_t c = 0; c < wanted.columns.size(); ++c) {
      const auto right = factors_of(sensitivity.right.col(at(c)), wanted.columns[c]);
      std::map<std::size_t, frf::ErrorSums::Term> sum;
      for (const auto& [k, l_factor] : left) {
        for (const auto& [l, r_factor] : right) {
          for (const frf::ErrorSums::Term& term : parts.of(k, l)) {
            frf::ErrorSums::Term& of = sum.try_emplace(term.error, frf::ErrorSums::Term{term.error, 0.0, term.relation}).first->second;
            of.factor += l_factor * r_factor * term.factor;
          }
        }
      }
      Terms terms;
      for (const auto& [error, term] : sum) terms.push_back(term);
      out.terms.push_back(std::move(terms));
    }
  }
  return out;
}

}  // namespace jointid::coupling
