#include "ident/likelihood/findings/bootstrap.hpp"

#include <oneapi/tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/eigen.hpp"
#include "base/parallel.hpp"
#include "base/statistics.hpp"
#include "ident/likelihood/data/likelihood_plan.hpp"
#include "ident/likelihood/findings/simulated_data.hpp"
#include "minimise/linear/covariance.hpp"

namespace jointid::ident {
namespace {

Replicate replicate_of(const LikelihoodFit& fit) {
  Replicate out{.theta = fit.theta, .error = {}, .usable = fit.converged};
  const Eigen::MatrixXd covariance = minimise::covariance_of(fit.information);
  for (std::size_t column = 0; column < fit.theta.size(); ++column) {
    const auto c = at(column);
    out.error.push_back(std::sqrt(covariance(c, c)));
    out.usable = out.usable && std::isfinite(fit.theta[column]) && out.error[column] > 0.0;
  }
  return out;
}

/// Priors as the bootstrap draws them: what was believed of the joint has errors, too.
std::vector<ScaledPrior> drawn(std::vector<ScaledPrior> priors, const std::vector<double>& theta, const RandomStream& stream) {
  for (std::size_t i = 0; i < priors.size(); ++i) {
    priors[i].value = theta[priors[i].column] + normal_numbers(stream, 0, i)[0] / priors[i].weight;
  }
  return priors;
}

}  // namespace

std::vector<Replicate> bootstrap(const Plan& plan, const LinearisedLikelihood& fitted, const LikelihoodFit& fit, const Control& control) {
  const LikelihoodPlan& own = *likelihood_plan(plan);
  const std::vector<ExactLine> exact = exact_lines(*own.observations, fitted, fit.theta);
  const IdentifySection& identify = plan.scene.identify;
  std::vector<Replicate> replicates(identify.bootstrap);
  oneapi::tbb::enumerable_thread_specific<SimulatedData> simulated([&] { return SimulatedData(*own.observations, fit.line_weight); });
  std::atomic<std::size_t> done = 0;
  const auto watch = [&](std::size_t) { stop_if(control.interrupted); };
  const auto run_one = [&](std::size_t b) {
    SimulatedData& data = simulated.local();
    data.draw(exact, {identify.bootstrap_seed, b, 0});
    LikelihoodEstimator estimator(data, plan.restriction, *plan.columns, plan.omega0,
                                  {.threads = 1,
                                   .priors = drawn(own.priors, fit.theta, {identify.bootstrap_seed, b, 1}),
                                   .line_watch = [&](std::size_t, std::size_t) { stop_if(control.interrupted); }});
    LinearisedLikelihood refined = std::move(estimator).refine(fit.theta, watch);
    if (plan.admissible) refined = std::move(refined).constrained(*plan.admissible, watch).fitted;
    replicates[b] = replicate_of(refined.fit);
    if (control.progress) control.progress("bootstrap", ++done, replicates.size());
  };
  for_each_index(replicates.size(), threads_or_cores(control.threads), run_one);
  return replicates;
}

BootstrapError bootstrap_error(const std::vector<Replicate>& replicates, std::size_t column, double estimate, double error) {
  std::vector<double> values, studentized;
  for (const Replicate& replicate : replicates) {
    if (!replicate.usable) continue;
    values.push_back(replicate.theta[column]);
    studentized.push_back((replicate.theta[column] - estimate) / replicate.error[column]);
  }
  double sum = 0.0, squares = 0.0;
  const auto n = static_cast<double>(values.size());
  for (const double value : values) sum += value;
  for (const double value : values) squares += (value - sum / n) * (value - sum / n);
  std::ranges::sort(studentized);
  return {std::sqrt(squares / (n - 1.0)),
          {estimate - quantile(studentized, 0.975) * error, estimate - quantile(studentized, 0.025) * error}};
}

}  // namespace jointid::ident
