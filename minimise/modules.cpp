#include "minimise/modules.hpp"

#include "base/module.hpp"

namespace jointid::minimise {
namespace {

const Module& ceres() {
  static const Module module{"ceres", "solver ceres", "libceres-dev"};
  return module;
}

const Module& nlopt() {
  static const Module module{"nlopt", "solver nlopt", "libnlopt-cxx-dev"};
  return module;
}

const Module& ipopt() {
  static const Module module{"ipopt", "solver ipopt", "coinor-libipopt-dev"};
  return module;
}

}  // namespace

bool has_ceres() { return is_there(ceres()); }
bool has_nlopt() { return is_there(nlopt()); }
bool has_ipopt() { return is_there(ipopt()); }

Minimum ceres_minimum(const LeastSquares& problem, std::span<const double> start, const CeresOptions& options) {
  return interface_of<CeresModule>(ceres()).minimum(problem, start, options);
}

BlockMinimum ceres_blocks(const std::vector<BlockTerm>& terms, const BlockOptions& options) {
  return interface_of<CeresModule>(ceres()).blocks(terms, options);
}

Minimum nlopt_minimum(const Objective& objective, std::span<const double> start, const NloptOptions& options) {
  return interface_of<NloptModule>(nlopt()).minimum(objective, start, options);
}

Minimum ipopt_minimum(const LeastSquares& problem, std::span<const double> start, const IpoptOptions& options) {
  return interface_of<IpoptModule>(ipopt()).minimum(problem, start, options);
}

}  // namespace jointid::minimise
