#pragma once

#include <vector>

#include "ident/likelihood/errors/error_trials.hpp"
#include "ident/likelihood/errors/line_scores.hpp"
#include "ident/likelihood/errors/shared_variances.hpp"

namespace jointid::ident {

/// What all responses to a reference have in common of their errors on a line, as the noise of a hammer's signal makes it: a relative
/// error e_k of the column k with the variance τ² of its real and of its imaginary part, the same for all references and lines of a
/// file.
struct SharedErrors {
  struct OfFile {
    double share = 0.0;         ///< τ²
    double deviation = 0.0;     ///< standard deviation of it
    double significance = 0.0;  ///< standard deviations above zero; of real parts and phases the less
    double variance = 0.0;      ///< median relative variance of a part of an FRF, that of its file
    Eigen::MatrixXd scatter;    ///< of the gradient of the unknowns, for τ² = 1
    double averages = 0.0;      ///< behind the variances
  };
  std::vector<OfFile> files;  ///< as ErrorTrials::files

  /// In one file or more: all are then taken to have them, as large as estimated.
  bool are_seen() const;
  /// Of the gradient by the errors; empty: none are seen.
  Eigen::MatrixXd scatter() const;
  /// By how much H1 may be too low in a file, relative, were all of it noise of the force: 2 (n − 1) τ² of n averages; 0 where nothing is
  /// seen. τ² is at most σ², so that this is not more than the coherences lack.
  double bias(std::size_t file) const;
  /// Standard deviation of bias().
  double bias_deviation(std::size_t file) const;
};

/// Sums over lines, one of them per run.
class SharedErrorSums {
 public:
  SharedErrorSums(const ErrorTrials& trials, std::size_t lines, std::size_t unknowns);
  void add(const ScoredLine& line);
  SharedErrorSums& operator+=(const SharedErrorSums& other);
  std::vector<double> numbers() const;
  void take(const std::vector<double>& numbers);
  SharedErrors result() const;

 private:
  void note_variances(const ScoredLine& line);

  const ErrorTrials* trials_;
  std::size_t unknowns_;
  SharedVariances squares_;  ///< kinds: file, real part or phase
  std::vector<Eigen::MatrixXd> scatter_;
  Eigen::VectorXd variance_, count_;  ///< Σ of logarithms of relative variances
};

}  // namespace jointid::ident
