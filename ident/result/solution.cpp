#include "ident/result/solution.hpp"

namespace jointid::ident {

std::string name(Status status) {
  switch (status) {
    case Status::rank_deficient:
      return "rank_deficient";
    case Status::no_equations:
      return "no_equations";
    case Status::not_converged:
      return "not_converged";
    case Status::imprecise:
      return "imprecise";
    case Status::doubtful:
      return "doubtful";
    case Status::poor_fit:
      return "poor_fit";
    case Status::ok:
      break;
  }
  return "ok";
}

std::string name(IntervalKind kind) {
  switch (kind) {
    case IntervalKind::cramer_rao:
      return "cramer_rao";
    case IntervalKind::bootstrap:
      return "bootstrap";
    case IntervalKind::none:
      break;
  }
  return "none";
}

std::string name(FindingKind kind) {
  switch (kind) {
    case FindingKind::weak_combination:
      return "weak_combination";
    case FindingKind::soft_joint:
      return "soft_joint";
    case FindingKind::stiff_joint:
      return "stiff_joint";
    case FindingKind::nonlinear:
      return "nonlinear";
    case FindingKind::calibration:
      return "calibration";
    case FindingKind::gain:
      return "gain";
    case FindingKind::misfit:
      break;
  }
  return "misfit";
}

}  // namespace jointid::ident
