#include "ident/solution.hpp"

namespace jointid::ident {

std::string name(Status status) {
  switch (status) {
    case Status::rank_deficient:
      return "rank_deficient";
    case Status::no_equations:
      return "no_equations";
    case Status::not_converged:
      return "not_converged";
    case Status::ok:
      break;
  }
  return "ok";
}

}  // namespace jointid::ident
