#include "ident/result/suspect.hpp"

#include <array>

namespace jointid::ident {

std::string name(SuspectKind kind) {
  static constexpr std::array<const char*, 20> names = {
      "sign", "swap", "label", "gain",  "unit",     "quantity",    "conjugate",      "delay",    "axis",
      "mass", "dead", "copy",  "loose", "exchange", "not_passive", "not_reciprocal", "nonlinear", "direction",
      "outlier", "force_noise"};
  return names[static_cast<std::size_t>(kind)];
}

std::string title(const Suspect& suspect) {
  std::string text = name(suspect.kind);
  const char* before = " ";
  for (const frf::Dof& dof : suspect.dofs) {
    text += before + dof.name();
    before = ", ";
  }
  return text + (suspect.file.empty() ? "" : " in " + suspect.file);
}

std::string name(Verdict verdict) {
  static constexpr std::array<const char*, 3> names = {"clean", "suspicious", "wrong"};
  return names[static_cast<std::size_t>(verdict)];
}

}  // namespace jointid::ident
