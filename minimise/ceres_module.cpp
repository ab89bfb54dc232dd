#include <ceres/ceres.h>
#include <glog/logging.h>

#include <exception>

#include "dense/one_blas_thread.hpp"
#include "minimise/modules.hpp"

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

/// Where the data do not determine an unknown the minimum may lie at infinity, and steps towards it never end. It is reached for
/// all that the data tell when ten steps change Σr² by less than a hundredth of the residual variance.
bool has_settled(const ceres::Solver::Summary& summary, std::size_t residuals) {
  constexpr std::size_t steps = 10;
  constexpr double negligible = 1e-2;
  if (summary.iterations.size() <= steps) return false;
  const double before = summary.iterations[summary.iterations.size() - 1 - steps].cost;
  return before - summary.final_cost < negligible * summary.final_cost / static_cast<double>(residuals);
}

Minimum minimum_of(const LeastSquares& least_squares, std::span<const double> start, const CeresOptions& given) {
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

class BlockCost final : public ceres::CostFunction {
 public:
  explicit BlockCost(const ResidualBlock& block) : block_(block) {
    set_num_residuals(static_cast<int>(block.residuals()));
    for (const std::size_t size : block.sizes()) mutable_parameter_block_sizes()->push_back(static_cast<int>(size));
  }

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    return block_.evaluate(parameters, residuals, jacobians);
  }

 private:
  const ResidualBlock& block_;
};

class BlockLoss final : public ceres::LossFunction {
 public:
  explicit BlockLoss(const Loss& loss) : loss_(loss) {}
  void Evaluate(double s, double rho[3]) const override { loss_.evaluate(s, rho); }

 private:
  const Loss& loss_;
};

/// Calls a function after every iteration; its exception must not fly through Ceres.
class AfterIteration final : public ceres::IterationCallback {
 public:
  explicit AfterIteration(const std::function<void()>& function) : function_(function) {}

  ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
    try {
      if (function_) function_();
      return ceres::SOLVER_CONTINUE;
    } catch (...) {
      thrown_ = std::current_exception();
      return ceres::SOLVER_ABORT;
    }
  }

  void rethrow() const {
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  const std::function<void()>& function_;
  std::exception_ptr thrown_;
};

BlockMinimum minimum_of_blocks(const std::vector<BlockTerm>& terms, const BlockOptions& given) {
  ceres::Problem problem;
  ceres::Solver::Options options;
  if (given.common != nullptr) {
    options.linear_solver_ordering = std::make_shared<ceres::ParameterBlockOrdering>();
    options.linear_solver_ordering->AddElementToGroup(given.common, 1);
  }
  for (const BlockTerm& term : terms) {
    problem.AddResidualBlock(new BlockCost(*term.block), term.loss != nullptr ? new BlockLoss(*term.loss) : nullptr,
                             term.parameters);
    for (double* parameters : term.parameters) {
      if (given.common != nullptr && parameters != given.common) options.linear_solver_ordering->AddElementToGroup(parameters, 0);
    }
  }
  if (given.constant != nullptr) problem.SetParameterBlockConstant(given.constant);
  options.logging_type = ceres::SILENT;
  options.num_threads = 1;
  options.linear_solver_type = given.common != nullptr ? ceres::DENSE_SCHUR : ceres::DENSE_QR;
  options.max_num_iterations = given.most_iterations;
  options.function_tolerance = given.function_tolerance;
  options.parameter_tolerance = given.parameter_tolerance;
  options.gradient_tolerance = given.gradient_tolerance;
  AfterIteration after(given.after_iteration);
  options.callbacks.push_back(&after);
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  after.rethrow();
  return {2.0 * summary.final_cost, summary.termination_type == ceres::CONVERGENCE};
}

class Ceres final : public CeresModule {
 public:
  Ceres() {
    FLAGS_logtostderr = true;
    FLAGS_minloglevel = google::GLOG_FATAL;
  }

  Minimum minimum(const LeastSquares& problem, std::span<const double> start, const CeresOptions& options) override {
    return minimum_of(problem, start, options);
  }

  BlockMinimum blocks(const std::vector<BlockTerm>& terms, const BlockOptions& options) override {
    return minimum_of_blocks(terms, options);
  }
};

}  // namespace
}  // namespace jointid::minimise

extern "C" void* jointid_module() {
  jointid::dense::use_one_blas_thread();
  static jointid::minimise::Ceres module;
  return static_cast<jointid::minimise::CeresModule*>(&module);
}
