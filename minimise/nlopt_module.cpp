#include <algorithm>
#include <cmath>
#include <nlopt.hpp>

#include "minimise/modules.hpp"

namespace jointid::minimise {
namespace {

/// The larger value that stands for "not defined": NLopt needs finite numbers.
constexpr double undefined = 1e100;

double value(const std::vector<double>& q, std::vector<double>&, void* objective) {
  const double at = (*static_cast<const Objective*>(objective))(q);
  return std::isfinite(at) ? std::min(at, undefined) : undefined;
}

nlopt::algorithm algorithm_of(Search search) {
  switch (search) {
    case Search::direct:
      return nlopt::GN_DIRECT_L;
    case Search::mlsl:
      return nlopt::G_MLSL_LDS;
    case Search::crs2:
      return nlopt::GN_CRS2_LM;
    default:
      return nlopt::LN_SBPLX;
  }
}

Minimum minimum_of(const Objective& objective, std::span<const double> start, const NloptOptions& options) {
  Minimum out{{start.begin(), start.end()}, 0, false};
  std::vector<double> lower = out.q, upper = out.q;
  for (std::size_t i = 0; i < out.q.size(); ++i) {
    lower[i] -= options.half_width;
    upper[i] += options.half_width;
  }
  const auto unknowns = static_cast<unsigned>(out.q.size());
  nlopt::opt search(algorithm_of(options.search), unknowns);
  if (options.search == Search::mlsl) {
    nlopt::opt local(nlopt::LN_SBPLX, unknowns);
    local.set_ftol_rel(1e-4);
    local.set_maxeval(100 * static_cast<int>(unknowns));
    search.set_local_optimizer(local);
  }
  if (options.search == Search::crs2) nlopt::srand(options.seed);
  search.set_lower_bounds(lower);
  search.set_upper_bounds(upper);
  search.set_min_objective(value, const_cast<Objective*>(&objective));
  search.set_maxeval(options.evaluations);
  if (options.tolerance > 0.0) search.set_xtol_rel(options.tolerance);
  double least = 0.0;
  std::vector<double> found = out.q;
  nlopt::result result = nlopt::FAILURE;
  try {
    result = search.optimize(found, least);
  } catch (const nlopt::roundoff_limited&) {
    least = objective(found);  // as near as numbers allow
    result = nlopt::XTOL_REACHED;
  }
  out.iterations = static_cast<std::size_t>(search.get_numevals());
  out.converged = result == nlopt::XTOL_REACHED || result == nlopt::FTOL_REACHED;
  if (least < objective(out.q)) out.q = std::move(found);
  return out;
}

class Nlopt final : public NloptModule {
 public:
  Minimum minimum(const Objective& objective, std::span<const double> start, const NloptOptions& options) override {
    return minimum_of(objective, start, options);
  }
};

}  // namespace
}  // namespace jointid::minimise

extern "C" void* jointid_module() {
  static jointid::minimise::Nlopt module;
  return static_cast<jointid::minimise::NloptModule*>(&module);
}
