#include "response/orbit/periodic_problem.hpp"

#include <numbers>

namespace jointid::response {

double PeriodicProblem::period() const { return 2.0 * std::numbers::pi / omega; }

}  // namespace jointid::response
