#pragma once

#include <ceres/cost_function.h>
#include <ceres/iteration_callback.h>
#include <ceres/loss_function.h>

#include <exception>

#include "ident/likelihood/fit/estimator.hpp"
#include "ident/likelihood/line/explicit_line.hpp"

namespace jointid::ident {

/// The joint's unknowns as Ceres has them: theta = centre + scale · t, with scale about their standard errors.
struct JointScale {
  std::vector<double> centre, scale;

  std::vector<double> theta(const double* t) const;
};

/// Residuals of a line by t and u.
class LineCost final : public ceres::CostFunction {
 public:
  LineCost(const ExplicitLine& line, const JointScale& joint);
  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override;

 private:
  const ExplicitLine& line_;
  const JointScale& joint_;
};

/// ρ(s) = s up to a limit l, beyond it l(2 − l/s). With l = 1.5² · redundancy the loss of LikelihoodEstimator.
class LineLoss final : public ceres::LossFunction {
 public:
  explicit LineLoss(double limit) : limit_(limit) {}
  void Evaluate(double s, double rho[3]) const override;

 private:
  double limit_;
};

/// Passes iterations on to a watcher, whose exception must not fly through Ceres.
class Watch final : public ceres::IterationCallback {
 public:
  Watch(const FitWatcher& watcher, std::size_t& iterations) : watcher_(watcher), iterations_(iterations) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override;
  void rethrow() const;

 private:
  const FitWatcher& watcher_;
  std::size_t& iterations_;
  std::exception_ptr thrown_;
};

}  // namespace jointid::ident
