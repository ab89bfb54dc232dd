#include "tasks/bound.hpp"

#include "ident/likelihood/findings/bound_of.hpp"
#include "ident/plan/joint_guess.hpp"

namespace jointid::tasks {

std::vector<double> cramer_rao_bound(const ident::Plan& plan, const std::vector<double>& values, const ident::Control& control) {
  read_for_bound(plan, control);
  return bound_of(plan, make_estimator(plan, control).at(scaled(plan, values)).fit.information);
}

}  // namespace jointid::tasks
