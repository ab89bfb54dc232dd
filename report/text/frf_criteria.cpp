#include "report/text/frf_criteria.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "correlation/criteria.hpp"

namespace jointid::report {

FrfCriteria criteria_of(std::span<const std::complex<double>> measured, std::span<const std::complex<double>> predicted) {
  std::vector<std::complex<double>> one, other;
  double sum = 0.0;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    const double lac = correlation::lac(measured[i], predicted[i]);
    if (measured[i] == 0.0 || !std::isfinite(lac)) continue;
    one.push_back(measured[i]);
    other.push_back(predicted[i]);
    sum += lac;
  }
  if (one.empty()) return {std::nan(""), std::nan("")};
  return {correlation::frac(one, other), sum / static_cast<double>(one.size())};
}

std::string criterion_text(double value) { return std::isfinite(value) ? fmt::format("{:.6f}", value) : "–"; }

std::string criteria_text(std::span<const std::complex<double>> measured, std::span<const std::complex<double>> predicted) {
  const FrfCriteria found = criteria_of(measured, predicted);
  if (!std::isfinite(found.frac)) return "";
  return fmt::format("FRAC {}, LAC {}", criterion_text(found.frac), criterion_text(found.lac));
}

}  // namespace jointid::report
