#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "ident/admissible/admissible_fit.hpp"
#include "ident/likelihood/fit/penalised_lines.hpp"
#include "ident/likelihood/fit/secant_steps.hpp"

namespace jointid::ident {

/// What steps have told of the curvature near the minimum; a constrained fit goes on from it.
struct StepMemory {
  SecantSteps secants;
  double shrinks = 1.0;  ///< a step over the one before, as last seen near the minimum
};

/// The set that a fit stays in, and the point of it that the last step went to.
struct Constraint {
  const AdmissibleSet& set;
  AdmissibleFit nearest;
};

/// The steps of the joint's unknowns from one start (LinearisedLikelihood). All that steers them is a member here and ends with it; the
/// lines stay where the last step put them. Stages are called in the order in which they stand below; each takes the fit where the last
/// one left it.
///
/// The loops are not `minimise::gauss_newton`: its residuals are a function of the unknowns, while here every step moves the true FRFs of
/// all lines with the joint (they are eliminated, not solved for), which is why a step that is refused puts the lines back; and weights
/// and the step's metric change on the way.
class JointIteration {
 public:
  /// `memory` outlives this. `watch` is called once per step.
  JointIteration(PenalisedLines& all, StepMemory& memory, SecondOpinion& opinion, const FitWatcher& watch, const FitListener& listener)
      : all_(all), memory_(memory), opinion_(opinion), watch_(watch), listener_(listener) {}

  /// The lines at a start, with all that earlier starts told forgotten; `linearised`: they are there already.
  LikelihoodFit begin(std::vector<double> start, bool linearised);

  /// Iterative quadratic maximum likelihood: the conditions at the measured FRFs, which are linear in the joint, whitened by the
  /// covariance that the last joint gives them, until a step is below `tolerance` standard deviations; false after `most` steps.
  /// `moves_frfs`: with the last step all FRFs take theirs: it is one of the implicit iteration, too.
  bool whiten(LikelihoodFit& fit, std::size_t most, double tolerance, bool moves_frfs);

  /// The implicit iteration (Gauss–Helmert), until near enough for project().
  void correct(LikelihoodFit& fit);

  enum class From {
    anywhere,     ///< lines are put on the constraint and linearised
    last_project,  ///< only weights have changed since
    measured  ///< lines stand where they were measured, and the joint is nearly right: linearised there, and put on the constraint
  };

  /// Gauss–Newton steps along the lines on their constraint, each shortened until Σ L falls, until less than `tolerance` standard
  /// deviations are left; whether it came so far. `known`: an end of another start; a fit that gets there goes no further. `within`: steps
  /// stay in a set.
  bool project(LikelihoodFit& fit, double tolerance, From from = From::anywhere, const LikelihoodFit* known = nullptr,
               Constraint* within = nullptr);

  /// All stages, to the end.
  void run(LikelihoodFit& fit, const LikelihoodFit* known);

  /// The stages until few standard deviations are left; whether they came so far, and the lines tell of all unknowns.
  bool approach(LikelihoodFit& fit);

  /// As run(), from where approach() ended on some of the lines: FRFs of all lines are linearised where they were measured, once, as long
  /// as steps shrink by that.
  void run_near(LikelihoodFit& fit, const LikelihoodFit* known);

 private:
  Eigen::VectorXd whitened_step(const std::vector<double>& theta, Eigen::MatrixXd& information);
  Eigen::VectorXd joint_step(const std::vector<double>& theta, const Eigen::MatrixXd& information, const Eigen::VectorXd& gradient,
                             Constraint* within);
  void linearise(const std::vector<double>& theta, double tolerance, bool shrinks);
  void begin_stages(LikelihoodFit& fit);
  void finish(LikelihoodFit& fit, const LikelihoodFit* known);
  std::optional<double> descend(LikelihoodFit& fit, const Eigen::VectorXd& step, Relaxation until, double& loss);
  bool is_hopeless(const std::vector<double>& theta, const std::vector<double>& losses);
  void finish_exactly(LikelihoodFit& fit, Relaxation until, Constraint* within);
  void polish(LikelihoodFit& fit, Relaxation until, Constraint* within);
  Relaxation relaxation(double tolerance) const;
  void tell(const LikelihoodFit& fit, double loss) const;
  void tell(const LikelihoodFit& fit) const;

  PenalisedLines& all_;
  StepMemory& memory_;
  SecondOpinion& opinion_;
  const FitWatcher& watch_;
  const FitListener& listener_;
  bool is_linearised_ = false;  ///< for the next whitened_step()
  bool is_near_ = false;        ///< run_near()
  double moved_ = 0.0;          ///< the joint since lines were linearised, in standard deviations
};

/// Fits of the joint's unknowns end when less than this is left, in standard deviations: those that the misfit makes, which may be
/// more than was assumed, or less (PenalisedLines::misfit_of()). A thousandth is nothing beside the interval that is told.
inline constexpr double settled = 1e-3;

/// How long a step is in standard deviations.
double norm_of(const Eigen::VectorXd& step, const Eigen::MatrixXd& information);

}  // namespace jointid::ident
