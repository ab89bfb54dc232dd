#include "coupling/dependency.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/text.hpp"

namespace jointid::coupling {
namespace {

constexpr double smallest_gap = 3.0, largest_dependent = 0.3;

double quantile(const std::vector<double>& sorted, double share) {
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1) + 0.5)];
}

Dependency describe(const std::string& name, std::vector<double> alphas) {
  Dependency out{.condition = name};
  std::erase_if(alphas, [](double value) { return std::isnan(value); });
  if (alphas.empty()) {
    out.median = out.lower = out.upper = std::nan("");
    return out;
  }
  std::ranges::sort(alphas);
  out.median = quantile(alphas, 0.5);
  out.lower = quantile(alphas, 0.05);
  out.upper = quantile(alphas, 0.95);
  return out;
}

struct Gap {
  double below = 0.0, above = 0.0;
};

/// The uppermost gap; nothing below when there is none.
std::optional<Gap> uppermost_gap(std::vector<double> medians) {
  medians.push_back(1.0);
  std::ranges::sort(medians, std::ranges::greater());
  for (std::size_t i = 0; i + 1 < medians.size(); ++i) {
    const Gap gap{medians[i + 1], medians[i]};
    if (gap.below < largest_dependent && smallest_gap * gap.below <= gap.above) return gap;
  }
  return std::nullopt;
}

}  // namespace

std::vector<bool> Dependencies::left_out() const {
  std::vector<bool> out;
  for (const Dependency& condition : conditions) out.push_back(condition.dependent);
  return out;
}

Dependencies find_dependencies(const std::vector<std::string>& conditions, const std::vector<LineRecord>& lines) {
  Dependencies out;
  std::vector<double> medians;
  for (std::size_t p = 0; p < conditions.size(); ++p) {
    std::vector<double> alphas;
    for (const LineRecord& line : lines) alphas.push_back(line.alpha[p]);
    out.conditions.push_back(describe(conditions[p], std::move(alphas)));
    if (!std::isnan(out.conditions.back().median)) medians.push_back(out.conditions.back().median);
  }
  const std::optional<Gap> gap = uppermost_gap(std::move(medians));
  if (!gap) {
    out.reason = "No condition is left out: no alphas below 0.3 stand apart from the others.";
    return out;
  }
  out.threshold = std::sqrt(std::max(gap->below, 1e-300) * gap->above);
  std::size_t count = 0;
  for (Dependency& condition : out.conditions) {
    condition.dependent = condition.median <= gap->below;
    count += condition.dependent ? 1 : 0;
  }
  out.reason = std::to_string(count) + " of " + std::to_string(conditions.size()) + " conditions " + (count == 1 ? "is" : "are") +
               " left out: the alphas have a gap between " + digits(gap->below) + " and " + digits(gap->above) +
               ", the others nearly imply what lies below.";
  return out;
}

}  // namespace jointid::coupling
