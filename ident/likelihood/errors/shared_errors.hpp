#pragma once

#include <vector>

#include "ident/likelihood/errors/error_trials.hpp"
#include "ident/likelihood/errors/line_scores.hpp"

namespace jointid::ident {

/// What all responses to a reference have in common of their errors on a line, as the noise of a hammer's signal makes it: a relative
/// error e_k of the column k with the variance τ² of its real and of its imaginary part, the same for all references and lines of a
/// file.
struct SharedErrors {
  struct OfFile {
    double share = 0.0;         ///< τ²
    double significance = 0.0;  ///< standard deviations above zero; of real parts and phases the less
    double variance = 0.0;      ///< median relative variance of a part of an FRF, that of its file
    Eigen::MatrixXd scatter;    ///< of the gradient of the unknowns, for τ² = 1
    double averages = 0.0;      ///< behind the variances
  };
  std::vector<OfFile> files;  ///< as ErrorTrials::files

  bool are_seen() const;
  /// Of the gradient by the errors that are seen; empty: none.
  Eigen::MatrixXd scatter() const;
  /// By how much H1 may be too low in a file, relative: 2 n τ² of n averages; 0 where nothing is seen. τ² is at most σ²,
  /// so that this is not more than the coherences lack.
  double bias(std::size_t file) const;
};

/// Sums over lines, one of them per run: E[g_k² − I_kk] = Σ_k' τ²_k' I_kk'² − τ²_k I_kk/σ² for the score g and information I of e_k at
/// the estimate, σ² the relative variance of a part of an FRF, of which τ² is a part.
class SharedErrorSums {
 public:
  SharedErrorSums(const ErrorTrials& trials, std::size_t unknowns);
  void add(const ScoredLine& line);
  SharedErrorSums& operator+=(const SharedErrorSums& other);
  std::vector<double> numbers() const;
  void take(const std::vector<double>& numbers);
  SharedErrors result() const;

 private:
  void note_variances(const ScoredLine& line);

  const ErrorTrials* trials_;
  std::size_t unknowns_;
  Eigen::MatrixXd squares_;  ///< Σ I_kk'², by the kinds of k and k': file, real part or phase
  Eigen::VectorXd excess_;   ///< Σ g_k² − I_kk, by kind
  Eigen::VectorXd information_;  ///< Σ I_kk, by kind
  std::vector<Eigen::MatrixXd> scatter_;
  Eigen::VectorXd variance_, count_;  ///< Σ of logarithms of relative variances
};

}  // namespace jointid::ident
