#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "ident/admissible/admissible_fit.hpp"
#include "ident/likelihood/data/scaled_prior.hpp"
#include "ident/likelihood/fit/fitted_lines.hpp"
#include "ident/likelihood/fit/secant_steps.hpp"

namespace jointid::ident {

/// What the likelihood found, in the scaled unknowns x = {k, ω₀²m, ω₀c, d} and after them those of systematic errors.
struct LikelihoodFit {
  std::vector<double> theta;
  Eigen::MatrixXd information;    ///< Σ weighted reduced information at theta: its inverse is the Cramér–Rao covariance
  std::vector<double> line_cost;  ///< χ² per line
  std::vector<double> line_weight;  ///< robust weight, 1 for a line that fits, 0 for one that says nothing of the joint
  std::size_t iterations = 0;       ///< steps of the joint's unknowns
  std::size_t starts = 0;           ///< how many starts were tried
  double loss = 0.0;                ///< Σ L
  bool converged = false;           ///< the last step was below 10⁻³ standard deviations
  bool reached_known = false;       ///< ended where another start had settled
  bool hopeless = false;  ///< stopped, or no other start tried, because steps and starts did not mend lines that are far from fitting
  std::size_t bytes = 0;            ///< of the lines' states and what was linearised about them

  struct End {
    double loss;
    std::vector<double> theta;
  };
  std::vector<End> ends;  ///< of all starts that settled
};

/// How many starts are followed.
enum class Follow {
  until_it_fits,        ///< by χ², unless it is doubtful: then all
  until_reached_twice,  ///< it fits, by χ² at 95 % too, and two starts ended in the best; else all: for data with several minima.
                        ///< A start that comes to within its standard deviation is not followed to the end
  all
};

/// The estimate under the constraints of a scene, and what they cost.
struct ConstrainedFit {
  LikelihoodFit fit;
  AdmissibleFit admissible;  ///< costs are those of Σ L; theta is that of the fit
};

/// Whether an estimate is so uncertain that another minimum may fit as well.
using Doubt = std::function<bool(const LikelihoodFit& fit)>;

/// The k-th start, or empty when there is no other.
using Starts = std::function<std::optional<std::vector<double>>(std::size_t k)>;

/// Watches a fit; called once per iteration, may throw to stop it.
using FitWatcher = std::function<void(std::size_t iteration)>;

/// Maximum-likelihood estimate of the joint with all FRFs taken as noisy (docs/formulas.md §11d): minimises Σ_lines L(χ²) over the
/// joint's unknowns and the true substructure FRFs of every line; L is χ² for lines that fit, and bounded for those with gross
/// errors. Three stages:
///  1. a few steps of iterative quadratic maximum likelihood;
///  2. the implicit iteration (Gauss–Helmert), which corrects the FRFs of both systems off the constraint and so comes near from
///     poor starts;
///  3. Gauss–Newton steps of the joint and of the FRFs of every line, which are eliminated from the step, shortened until Σ L falls;
///     where χ² of a line is not what was predicted, and in the end, its FRFs are optimised for the joint (Levenberg–Marquardt of
///     the line on its own). The cost never rises.
/// Where variances follow a law of the value they are then taken at the estimated values and stage 3 is repeated until the joint
/// stays: weights at measured values bias the estimate.
class LikelihoodEstimator {
 public:
  LikelihoodEstimator(LikelihoodData& observations, const restrictions::Restriction& restriction, const UnknownColumns& columns,
                      double omega0, std::size_t threads);

  /// Asked at most once per run, and only where most lines are far from fitting: whether the data contradict every joint, as
  /// something else than this fit tells. Then one start is followed, and no longer than steps mend the misfit by a third.
  void set_second_opinion(std::function<bool(const std::vector<double>& theta)> opinion) { second_opinion_ = std::move(opinion); }

  /// Normal priors count like measurements: information += 1/σ², gradient += (value − θ)/σ², cost += ((value − θ)/σ)².
  void set_priors(std::vector<ScaledPrior> priors) { priors_ = std::move(priors); }

  /// See FittedLines::set_watch().
  void set_line_watch(std::function<void(std::size_t begun, std::size_t lines)> watch) { lines_.set_watch(std::move(watch)); }

  /// Called with every estimate on the way and Σ L there, infinite before the FRFs of the lines are optimised.
  void set_listener(std::function<void(const LikelihoodFit& fit, double loss)> listener) { listener_ = std::move(listener); }

  /// Starts are of the joint's unknowns, systematic errors begin at zero.
  /// From the first start, and from the next while χ² tells that the fit is not the right minimum, or from all; the best of them.
  LikelihoodFit run(const Starts& starts, const FitWatcher& watch, Follow follow = Follow::until_it_fits, const Doubt& doubtful = {});

  /// The second stage alone, from a start that is nearly right.
  LikelihoodFit refine(std::vector<double> start, const FitWatcher& watch);

  /// Only iterative quadratic maximum likelihood, to its end: the conditions between the measured FRFs, which are linear in the
  /// joint, whitened by the covariance that the last joint gives them. Each step costs as much as one of the Gauss–Helmert
  /// iteration and no line can get stuck, but errors of the coefficients bias it: for small noise only as good as run().
  LikelihoodFit run_whitened(std::vector<double> start, const FitWatcher& watch);

  /// From an estimate of run(), refine() or another solver on to the minimum of Σ L over the joints of `set`, with weights of lines
  /// and variances as they are: Gauss–Newton steps, each to the minimum of the quadratic model under the constraints
  /// (nearest_admissible() in the metric of the information), shortened until Σ L falls. All steps stay in the set, which is
  /// convex. The estimate itself when it is in the set.
  ConstrainedFit constrain(LikelihoodFit fit, const AdmissibleSet& set, const FitWatcher& watch);

  /// How far the lines are from fitting a joint, to rank starts by: the mean over the lines of log(1 + χ²/r), weighted by their
  /// redundancy r, with χ² as linearised where the iteration would begin. A few lines near resonances do not decide it.
  double misfit_at(std::vector<double> theta);

  /// The Fisher information of the data on all unknowns if the joint were `theta`: its inverse is the Cramér–Rao bound.
  Eigen::MatrixXd information_at(std::vector<double> theta);

  /// godambe_information() at a fit of run(), where the lines stand.
  Eigen::MatrixXd godambe_information_at(const LikelihoodFit& fit);

  /// What one line contributes to the information that was worked out last, without its robust weight.
  Eigen::MatrixXd information_of(std::size_t line) const;

  /// The estimated true FRFs of a line; empty matrices for a line that is not used.
  const LineState& state_of(std::size_t line) const { return lines_[line].state; }

  /// As it was fitted and linearised last.
  const FittedLine& line_at(std::size_t line) const { return lines_[line]; }

  /// Z_j of a line.
  ComplexMatrix impedance_of(std::size_t line, const std::vector<double>& theta) const { return lines_.impedance(line, theta); }

 private:
  double total(const std::vector<double>& theta) const;
  void sum(const std::vector<double>& theta, Eigen::MatrixXd& information, Eigen::VectorXd& gradient) const;
  double misfit_of(double loss) const;  ///< errors over those that were assumed: √(loss over its expectation), at most 1
  Eigen::VectorXd whitened_step(const std::vector<double>& theta, Eigen::MatrixXd& information);
  bool whitened_stage(LikelihoodFit& fit, std::size_t most, double tolerance, bool moves_frfs, const FitWatcher& watch);
  void implicit_stage(LikelihoodFit& fit, const FitWatcher& watch);
  Eigen::VectorXd joint_step(const std::vector<double>& theta, const Eigen::MatrixXd& information, const Eigen::VectorXd& gradient);
  enum class From {
    anywhere,     ///< lines are put on the constraint and linearised
    last_project  ///< only weights have changed since
  };
  void finish_exactly(LikelihoodFit& fit, Relaxation until);
  /// `known`: an end of another start; a fit that gets there goes no further.
  bool project(LikelihoodFit& fit, double tolerance, const FitWatcher& watch, From from = From::anywhere,
               const LikelihoodFit* known = nullptr);
  Relaxation relaxation(double tolerance) const;
  bool far_from_fitting() const;
  bool beyond_any_joint(const std::vector<double>& theta);
  LikelihoodFit begun(std::vector<double> start);
  LikelihoodFit run_from(std::vector<double> start, const FitWatcher& watch, const LikelihoodFit* known);
  void finish(LikelihoodFit& fit) const;
  void tell(const LikelihoodFit& fit, double loss = std::numeric_limits<double>::infinity()) const {
    if (listener_) listener_(fit, loss);
  }

  std::function<void(const LikelihoodFit&, double)> listener_;
  std::function<bool(const std::vector<double>&)> second_opinion_;
  std::optional<bool> beyond_any_joint_;  ///< what it said
  std::size_t unknowns_;  ///< with those of systematic errors
  std::size_t joint_unknowns_;
  FittedLines lines_;
  std::vector<ScaledPrior> priors_;
  const AdmissibleSet* admissible_ = nullptr;  ///< while a fit is constrained
  AdmissibleFit nearest_;                      ///< of the last step under constraints
  SecantSteps secants_;
  std::optional<std::vector<double>> linearised_at_;  ///< where lines stand as begun() leaves them, and are linearised already
  bool is_linearised_ = false;                        ///< for the next whitened_step()
  double moved_ = 0.0;                                ///< the joint since lines were linearised, in standard deviations
  double shrinks_ = 1.0;  ///< a step over the one before, as last seen near the minimum
};

}  // namespace jointid::ident
