#pragma once

#include <Eigen/Core>
#include <vector>

namespace jointid::ident {

/// Squares of the scores of errors on lines and what they are expected to be. Errors are of kinds, and those of a kind have the same
/// variance τ²:
///   E g_k² = I_kk + Σ_l τ²_l I_kl² − τ²_k I_kk/σ²,
/// g_k and I the scores and their information, σ² the relative variance that I takes for that of a part of an FRF, of which τ² is a
/// part.
class SharedVariances {
 public:
  /// Of `count` errors on a line. `kinds`: of an error; at most 512 of the `lines` are kept, spread over all.
  SharedVariances(std::size_t lines, std::vector<std::size_t> kind, std::size_t kinds);

  bool keeps(std::size_t line) const { return line % every_ == 0; }
  void add(std::size_t line, const Eigen::VectorXd& gradient, const Eigen::MatrixXd& information);
  SharedVariances& operator+=(SharedVariances other);
  std::vector<double> numbers() const;
  void take(const std::vector<double>& numbers);

  struct Found {
    Eigen::VectorXd variance;    ///< τ² by kind, not less than it may be; zero of kinds without any error
    Eigen::MatrixXd covariance;  ///< of these, by what lines scatter
  };
  /// By the composite likelihood of the margins g_k ~ N(0, E g_k²) (Varin, Reid & Firth 2011): squares are weighed by what they are
  /// expected to scatter, so that no few errors decide that the data tell much of. `most`: σ² by kind.
  Found estimate(const Eigen::VectorXd& most) const;

  /// By kind: standard deviations of Σ w_k (g_k² − I_kk) above zero, were there no such errors. Weights w are those of τ² = σ².
  Eigen::VectorXd significance(const Eigen::VectorXd& most) const;

 private:
  /// g², I_kk and Σ_l I_kl² by the kinds of l.
  using Squares = Eigen::MatrixXd;  ///< [errors, 2 + kinds]

  Eigen::MatrixXd coefficients(const Squares& line, const Eigen::VectorXd& most) const;

  std::size_t every_ = 1, kinds_;
  std::vector<std::size_t> kind_;
  std::vector<Squares> lines_;  ///< empty: none yet
};

}  // namespace jointid::ident
