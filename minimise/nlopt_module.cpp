#include <algorithm>
#include <cmath>
#include <nlopt.hpp>

#include "minimise/modules.hpp"

namespace jointid::minimise {
namespace {

/// The larger value that stands for "not defined": NLopt needs finite numbers.
constexpr double undefined = 1e100;

double value(const std::vector<double>& q, std::vector<double>& gradient, void* objective) {
  const double at = (*static_cast<const Slopes*>(objective))(q, gradient);
  if (std::isfinite(at) && at < undefined) return at;
  std::ranges::fill(gradient, 0.0);
  return undefined;
}

nlopt::algorithm algorithm_of(Search search) {
  switch (search) {
    case Search::direct:
      return nlopt::GN_DIRECT_L;
    case Search::mlsl:
      return nlopt::G_MLSL_LDS;
    default:
      return nlopt::LD_SLSQP;
  }
}

Minimum minimum_of(const Slopes& objective, std::span<const double> start, const NloptOptions& options) {
  Minimum out{{start.begin(), start.end()}, 0, false};
  std::vector<double> lower = out.q, upper = out.q;
  for (std::size_t i = 0; i < out.q.size(); ++i) {
    lower[i] -= options.half_width;
    upper[i] += options.half_width;
  }
  const auto unknowns = static_cast<unsigned>(out.q.size());
  nlopt::opt search(algorithm_of(options.search), unknowns);
  if (options.search == Search::mlsl) {
    nlopt::opt local(nlopt::LD_SLSQP, unknowns);
    local.set_ftol_rel(1e-8);
    local.set_xtol_rel(1e-8);
    local.set_maxeval(200);
    search.set_local_optimizer(local);
  }
  search.set_lower_bounds(lower);
  search.set_upper_bounds(upper);
  search.set_min_objective(value, const_cast<Slopes*>(&objective));
  search.set_maxeval(options.evaluations);
  if (options.tolerance > 0.0) search.set_xtol_rel(options.tolerance);
  double least = 0.0;
  std::vector<double> found = out.q;
  nlopt::result result = nlopt::FAILURE;
  try {
    result = search.optimize(found, least);
  } catch (const nlopt::roundoff_limited&) {
    least = objective(found, {});  // as near as numbers allow
    result = nlopt::XTOL_REACHED;
  }
  out.iterations = static_cast<std::size_t>(search.get_numevals());
  out.converged = result == nlopt::XTOL_REACHED || result == nlopt::FTOL_REACHED;
  if (least < objective(out.q, {})) out.q = std::move(found);
  return out;
}

class Nlopt final : public NloptModule {
 public:
  Minimum minimum(const Slopes& objective, std::span<const double> start, const NloptOptions& options) override {
    return minimum_of(objective, start, options);
  }
};

}  // namespace
}  // namespace jointid::minimise

extern "C" void* jointid_module() {
  static jointid::minimise::Nlopt module;
  return static_cast<jointid::minimise::NloptModule*>(&module);
}
