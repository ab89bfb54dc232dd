#include "ident/check/suspect.hpp"

#include <array>

namespace jointid::ident {

std::string name(SuspectKind kind) {
  static constexpr std::array<const char*, 17> names = {
      "sign", "swap", "label", "gain",  "unit",     "quantity",    "conjugate",      "delay",    "axis",
      "mass", "dead", "copy",  "loose", "exchange", "not_passive", "not_reciprocal", "nonlinear"};
  return names[static_cast<std::size_t>(kind)];
}

std::string name(Verdict verdict) {
  static constexpr std::array<const char*, 3> names = {"clean", "suspicious", "wrong"};
  return names[static_cast<std::size_t>(verdict)];
}

}  // namespace jointid::ident
