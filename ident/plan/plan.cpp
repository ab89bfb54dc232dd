#include "ident/plan/plan.hpp"

#include "restrictions/impedance_factor.hpp"

namespace jointid::ident {

PlannedMethod undecided(const Plan& plan) {
  PlannedMethod out;
  out.coordinates = plan.coordinates;
  out.equations = plan.equations;
  return out;
}

double Plan::unscale(std::size_t column) const {
  return restrictions::unscale(restriction.unknowns[columns->unknown_of(column)].kind, omega0);
}

}  // namespace jointid::ident
