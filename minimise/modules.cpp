#include "minimise/modules.hpp"

#include "base/module.hpp"

namespace jointid::minimise {
namespace {

constexpr Module ceres{"ceres", "solver ceres", "libceres-dev"};
constexpr Module ipopt{"ipopt", "solver ipopt", "coinor-libipopt-dev"};

}  // namespace

bool has_ceres() { return is_there(ceres); }
bool has_ipopt() { return is_there(ipopt); }

Minimum ceres_minimum(const LeastSquares& problem, std::span<const double> start, const CeresOptions& options) {
  return interface_of<CeresModule>(ceres).minimum(problem, start, options);
}

BlockMinimum ceres_blocks(const std::vector<BlockTerm>& terms, const BlockOptions& options) {
  return interface_of<CeresModule>(ceres).blocks(terms, options);
}

Minimum ipopt_minimum(const LeastSquares& problem, std::span<const double> start, const IpoptOptions& options) {
  return interface_of<IpoptModule>(ipopt).minimum(problem, start, options);
}

}  // namespace jointid::minimise
