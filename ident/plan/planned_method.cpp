#include "ident/plan/planned_method.hpp"

#include "ident/plan/plan.hpp"

namespace jointid::ident {

PlannedMethod undecided(const Plan& plan) {
  PlannedMethod out;
  out.coordinates = plan.coordinates;
  out.equations = plan.equations;
  return out;
}

}  // namespace jointid::ident
