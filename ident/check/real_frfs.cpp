#include "ident/check/real_frfs.hpp"

#include <algorithm>
#include <cmath>

namespace jointid::ident {
namespace {

/// Whether some values are not zero, and all of these are real.
bool is_real(const CheckedFile& file) {
  bool any = false;
  for (const Eigen::MatrixXcd& line : file.frfs) {
    for (const Complex value : line.reshaped()) {
      if (!std::isfinite(std::norm(value))) continue;
      if (value.imag() != 0.0) return false;
      any = any || value.real() != 0.0;
    }
  }
  return any;
}

bool is_complex(const CheckedFile& file) {
  return std::ranges::any_of(file.frfs, [](const Eigen::MatrixXcd& line) {
    return std::ranges::any_of(line.reshaped(), [](Complex value) { return std::isfinite(value.imag()) && value.imag() != 0.0; });
  });
}

}  // namespace

std::vector<Suspect> find_real_assemblies(const std::vector<CheckedFile>& files) {
  constexpr std::size_t least_lines = 2;
  if (std::ranges::none_of(files, [](const CheckedFile& file) { return !file.assembly && is_complex(file); })) return {};
  std::vector<Suspect> found;
  for (const CheckedFile& file : files) {
    if (!file.assembly || file.frfs.size() < least_lines || !is_real(file)) continue;
    found.push_back(
        {.kind = SuspectKind::quantity,
         .file = file.name,
         .dofs = {},
         .evidence =
             "its FRFs are real throughout, and those of the parts are not: magnitudes, decibels or one part of complex FRFs",
         .confidence = 0.99,
         .remedy = "# export real and imaginary part of " + file.name});
  }
  return found;
}

bool are_all_real(const std::vector<CheckedFile>& files) {
  return !files.empty() && std::ranges::none_of(files, is_complex) && std::ranges::any_of(files, is_real);
}

}  // namespace jointid::ident
