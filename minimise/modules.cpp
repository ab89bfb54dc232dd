#include "minimise/modules.hpp"

#include <stdexcept>

#include "base/module.hpp"

namespace jointid::minimise {
namespace {

constexpr Module ceres{"ceres", "solver ceres", "libceres-dev"};
constexpr Module nlopt{"nlopt", "solver nlopt", "libnlopt-cxx-dev"};
constexpr Module ipopt{"ipopt", "solver ipopt", "coinor-libipopt-dev"};

}  // namespace

bool has_ceres() { return is_there(ceres); }
bool has_nlopt() { return is_there(nlopt); }
bool has_ipopt() { return is_there(ipopt); }

Minimum ceres_minimum(const LeastSquares& problem, std::span<const double> start, const CeresOptions& options) {
  return interface_of<CeresModule>(ceres).minimum(problem, start, options);
}

BlockMinimum ceres_blocks(const std::vector<BlockTerm>& terms, const BlockOptions& options) {
  return interface_of<CeresModule>(ceres).blocks(terms, options);
}

Minimum nlopt_minimum(const Slopes& objective, std::span<const double> start, const NloptOptions& options) {
  return interface_of<NloptModule>(nlopt).minimum(objective, start, options);
}

Minimum nlopt_minimum(const Objective& objective, std::span<const double> start, const NloptOptions& options) {
  if (options.search != Search::direct) throw std::logic_error("a search of NLopt needs the gradient");
  return nlopt_minimum([&](std::span<const double> q, std::span<double>) { return objective(q); }, start, options);
}

Minimum ipopt_minimum(const LeastSquares& problem, std::span<const double> start, const IpoptOptions& options) {
  return interface_of<IpoptModule>(ipopt).minimum(problem, start, options);
}

}  // namespace jointid::minimise
