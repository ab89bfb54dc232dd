#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "ident/likelihood/data/scaled_prior.hpp"
#include "ident/likelihood/fit/fitted_lines.hpp"
#include "ident/likelihood/fit/likelihood_fit.hpp"

namespace jointid::ident {

/// The lines of a likelihood and the priors of its unknowns: what a fit sums over. Normal priors count like measurements:
/// information += 1/σ², gradient += (value − θ)/σ², cost += ((value − θ)/σ)².
struct PenalisedLines {
  FittedLines lines;
  std::vector<ScaledPrior> priors;
  std::size_t unknowns = 0;        ///< with those of systematic errors
  std::size_t joint_unknowns = 0;  ///< the first ones

  /// Σ L and the priors' cost.
  double total(const std::vector<double>& theta) const;

  /// Σ weighted information and gradient of the lines as they are linearised, and of the priors.
  void sum(const std::vector<double>& theta, Eigen::MatrixXd& information, Eigen::VectorXd& gradient) const;

  /// Errors over those that were assumed: √(loss over its expectation), from 10⁻⁶ to 1.
  double misfit_of(double loss) const;

  /// Whether most lines are further than three times their errors off.
  bool are_far_from_fitting() const;

  /// Σ L, χ² and weights of the lines as they are, into a fit that ended here.
  void finish(LikelihoodFit& fit) const;
};

/// What FollowOptions::second_opinion says, asked once.
class SecondOpinion {
 public:
  explicit SecondOpinion(std::function<bool(const std::vector<double>& theta)> ask = {}) : ask_(std::move(ask)) {}

  /// Whether data that are far from fitting contradict every joint.
  bool is_beyond_any_joint(const PenalisedLines& all, const std::vector<double>& theta);

 private:
  std::function<bool(const std::vector<double>&)> ask_;
  std::optional<bool> said_;
};

}  // namespace jointid::ident
