#include "ident/result/solution.hpp"

namespace jointid::ident {

std::string name(IntervalKind kind) {
  switch (kind) {
    case IntervalKind::cramer_rao:
      return "cramer_rao";
    case IntervalKind::bootstrap:
      return "bootstrap";
    case IntervalKind::sandwich:
      return "sandwich";
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
