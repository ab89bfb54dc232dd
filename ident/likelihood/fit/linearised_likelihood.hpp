#pragma once

#include <functional>
#include <vector>

#include "ident/admissible/admissible_fit.hpp"
#include "ident/likelihood/fit/joint_iteration.hpp"
#include "ident/likelihood/fit/penalised_lines.hpp"

namespace jointid::ident {

struct ConstrainedFit;

/// A joint and the lines of its likelihood where they stand for it: what a fit leaves (LikelihoodEstimator::run() and the like), or a joint
/// that was given (LikelihoodEstimator::at()). What is said of a fit afterwards is asked of this.
class LinearisedLikelihood {
 public:
  LinearisedLikelihood(PenalisedLines all, LikelihoodFit at, StepMemory memory = {}, SecondOpinion opinion = SecondOpinion())
      : fit(std::move(at)), all_(std::move(all)), memory_(std::move(memory)), opinion_(std::move(opinion)) {}

  LikelihoodFit fit;

  /// `other`, which another solver found from here. `brings_lines`: they are brought there (of what was linearised before nothing holds
  /// then), for what is said of it; else only `other` may be used.
  LinearisedLikelihood moved_to(LikelihoodFit other, bool brings_lines) &&;

  /// From here on to the minimum of Σ L over the joints of `set`, with weights of lines and variances as they are: Gauss–Newton steps,
  /// each to the minimum of the quadratic model under the constraints (nearest_admissible() in the metric of the information), shortened
  /// until Σ L falls. All steps stay in the set, which is convex. The estimate itself when it is in the set.
  ConstrainedFit constrained(const AdmissibleSet& set, const FitWatcher& watch) &&;

  /// The first gradients of godambe_information(), which another pass over the lines works out where it has their factors.
  struct NearbyGradients {
    std::vector<Eigen::VectorXd> offsets{};   ///< none: these are not of use
    std::vector<Eigen::MatrixXd> of_lines{};  ///< FittedLines::gradients_nearby()
  };
  NearbyGradients begin_godambe() const;
  /// By any thread; `model` has the factors of the line.
  void take_nearby(std::size_t line, LineModel& model, NearbyGradients& to) const;

  /// godambe_information() here. The lines move meanwhile, and are put back. `begun`: lines that it has are not worked out again.
  Eigen::MatrixXd godambe_information(NearbyGradients begun);
  Eigen::MatrixXd godambe_information() { return godambe_information(NearbyGradients()); }

  /// What one line contributes to the information, without its robust weight.
  Eigen::MatrixXd information_of(std::size_t line) const;

  /// The estimated true FRFs of a line; empty matrices for a line that is not used.
  const LineState& state_of(std::size_t line) const { return all_.lines[line].state; }

  /// As it was fitted and linearised last.
  const FittedLine& line_at(std::size_t line) const { return all_.lines[line]; }

  /// Z_j of a line.
  ComplexMatrix impedance_of(std::size_t line, const std::vector<double>& theta) const { return all_.lines.impedance(line, theta); }

 private:
  PenalisedLines all_;
  StepMemory memory_;
  SecondOpinion opinion_;
};

/// The estimate under the constraints of a scene, and what they cost.
struct ConstrainedFit {
  LinearisedLikelihood fitted;
  AdmissibleFit admissible;  ///< costs are those of Σ L; theta is that of the fit
};

/// The lines brought to a joint, all of weight 1: the Fisher information there. Its inverse is the Cramér–Rao bound.
Eigen::MatrixXd linearise_at(const std::vector<double>& theta, PenalisedLines& all);

}  // namespace jointid::ident
