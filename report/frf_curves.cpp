#include "report/frf_curves.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace jointid::report {

std::vector<double> magnitudes(std::span<const std::complex<double>> frf) {
  std::vector<double> out;
  for (const auto& value : frf) out.push_back(std::abs(value) > 0.0 ? std::abs(value) : std::numeric_limits<double>::quiet_NaN());
  return out;
}

std::vector<double> phases_deg(std::span<const std::complex<double>> frf, std::span<const std::size_t> indices) {
  std::vector<double> out;
  for (const std::size_t i : indices) out.push_back(std::arg(frf[i]) * 180.0 / std::numbers::pi);
  return out;
}

std::string receptance_label(const frf::Dof& response, const frf::Dof& reference) {
  const std::string moved = response.is_rotation() ? "rad" : "m";
  return "receptance (" + moved + (reference.is_rotation() ? "/(N·m))" : "/N)");
}

std::string drawn_text(std::size_t drawn, std::size_t all) {
  return drawn < all ? fmt::format("{} of {} FRFs are drawn, those that are met worst among them.", drawn, all) : "";
}

}  // namespace jointid::report
