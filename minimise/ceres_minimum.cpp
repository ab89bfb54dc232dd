#include <ceres/ceres.h>
#include <glog/logging.h>

#include "minimise/least_squares.hpp"

namespace jointid::minimise {
namespace {

class Cost final : public ceres::CostFunction {
 public:
  explicit Cost(const LeastSquares& problem) : problem_(problem) {
    set_num_residuals(static_cast<int>(problem.residuals()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(problem.unknowns()));
  }

  bool Evaluate(double const* const* q, double* r, double** jacobian) const override {
    const bool wanted = jacobian != nullptr && jacobian[0] != nullptr;
    const std::size_t size = problem_.residuals() * problem_.unknowns();
    return problem_.evaluate({q[0], problem_.unknowns()}, {r, problem_.residuals()},
                             wanted ? std::span(jacobian[0], size) : std::span<double>());
  }

 private:
  const LeastSquares& problem_;
};

/// Where the data do not determine an unknown the minimum may lie at infinity, and steps towards it never end. It is reached for all
/// that the data tell when ten steps change Σr² by less than a hundredth of the residual variance.
bool has_settled(const ceres::Solver::Summary& summary, std::size_t residuals) {
  constexpr std::size_t steps = 10;
  constexpr double negligible = 1e-2;
  if (summary.iterations.size() <= steps) return false;
  const double before = summary.iterations[summary.iterations.size() - 1 - steps].cost;
  return before - summary.final_cost < negligible * summary.final_cost / static_cast<double>(residuals);
}

}  // namespace

bool has_ceres() { return true; }

Minimum ceres_minimum(const LeastSquares& least_squares, std::span<const double> start, const CeresOptions& given) {
  FLAGS_logtostderr = true;
  FLAGS_minloglevel = google::GLOG_FATAL;
  Minimum out{{start.begin(), start.end()}, 0, false};
  ceres::Problem problem;
  problem.AddResidualBlock(new Cost(least_squares), nullptr, out.q.data());
  ceres::Solver::Options options;
  options.logging_type = ceres::SILENT;
  options.num_threads = 1;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = given.most_iterations;
  options.function_tolerance = given.tolerance;
  options.gradient_tolerance = given.gradient_tolerance;
  options.parameter_tolerance = given.parameter_tolerance;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  out.iterations = summary.iterations.size();
  out.converged = summary.termination_type == ceres::CONVERGENCE || has_settled(summary, least_squares.residuals());
  return out;
}

}  // namespace jointid::minimise
