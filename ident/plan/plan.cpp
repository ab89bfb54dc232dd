#include "ident/plan/plan.hpp"

#include "ident/plan/scaling.hpp"

namespace jointid::ident {

double Plan::unscale(std::size_t column) const {
  return ident::unscale(restriction.unknowns[columns->unknown_of(column)].kind, omega0);
}

}  // namespace jointid::ident
