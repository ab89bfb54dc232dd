#pragma once

#include <functional>
#include <vector>

#include "ident/likelihood/line_model.hpp"
#include "ident/likelihood/observations.hpp"

namespace jointid::ident {

/// What the likelihood found, in the scaled unknowns x = {k, ω₀²m, ω₀c, d}.
struct LikelihoodFit {
  std::vector<double> theta;
  Eigen::MatrixXd information;    ///< Σ weighted reduced information at theta: its inverse is the Cramér–Rao covariance
  std::vector<double> line_cost;  ///< χ² per line
  std::vector<double> line_weight;  ///< robust weight, 1 for a line that fits
  std::size_t iterations = 0;       ///< steps of the joint's unknowns
  bool converged = false;           ///< the last step was below the tolerance and no line could be improved
  std::size_t bytes = 0;            ///< of the lines' states and what was linearised about them
};

/// Watches a fit; called once per iteration, may throw to stop it.
using FitWatcher = std::function<void(std::size_t iteration)>;

/// Maximum-likelihood estimate of the joint with all FRFs taken as noisy (formulas §11): minimises Σ_lines L(χ²) over the
/// joint's unknowns and the true substructure FRFs of every line; L is χ² for lines that fit, and bounded for those with gross
/// errors. Two stages:
///  1. the implicit iteration (Gauss–Helmert), which corrects the FRFs of both systems off the constraint and so comes near from
///     poor starts;
///  2. variable projection: per line the FRFs are optimised to the end for the current joint (Levenberg–Marquardt of each line
///     on its own), then a Gauss–Newton step of the joint, shortened until Σ L falls. The cost never rises.
/// Where variances follow a law of the value they are then taken at the estimated values and stage 2 is repeated until the joint
/// stays: weights at measured values bias the estimate.
class LikelihoodEstimator {
 public:
  LikelihoodEstimator(Observations& observations, const restrictions::Restriction& restriction, const UnknownColumns& columns,
                      double omega0, std::size_t threads);

  LikelihoodFit run(std::vector<double> start, const FitWatcher& watch);

  /// Only iterative quadratic maximum likelihood, to its end: the conditions between the measured FRFs, which are linear in the
  /// joint, whitened by the covariance that the last joint gives them. Each step costs as much as one of the Gauss–Helmert
  /// iteration and no line can get stuck, but errors of the coefficients bias it: for small noise only as good as run().
  LikelihoodFit run_whitened(std::vector<double> start, const FitWatcher& watch);

  /// The Fisher information of the data on the joint's unknowns if the joint were `theta`: its inverse is the Cramér–Rao bound.
  Eigen::MatrixXd information_at(const std::vector<double>& theta);

 private:
  struct Line {
    JointImpedance joint;
    LineState state;
    double redundancy = 0.0;
    double cost = 0.0;
    double weight = 1.0;
    ReducedLine reduced;
  };

  void for_lines(const std::function<void(std::size_t, LineModel&)>& work) const;
  void begin(const std::vector<double>& theta);
  void choose_tolerance();
  void weigh();
  void sum(Eigen::MatrixXd& information, Eigen::VectorXd& gradient) const;
  double total() const;
  bool whitened_stage(LikelihoodFit& fit, std::size_t most, double tolerance, const FitWatcher& watch);
  void finish(LikelihoodFit& fit) const;
  void implicit_stage(LikelihoodFit& fit, const FitWatcher& watch);
  void linearise_all(const std::vector<double>& theta);
  void relax(std::size_t line, LineModel& model, const ComplexMatrix& z);
  void relax_all(const std::vector<double>& theta);
  bool project(LikelihoodFit& fit, double tolerance, const FitWatcher& watch);

  Observations& observations_;
  std::size_t unknowns_, threads_;
  std::vector<Line> lines_;
  double tolerance_ = 1.0;  ///< χ² over its expectation that counts as fitting
};

}  // namespace jointid::ident
