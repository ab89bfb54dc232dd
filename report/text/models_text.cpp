#include "report/text/models_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/text/table.hpp"

namespace jointid::report {
namespace {

using models::ModelUse, models::ModelWay;

constexpr std::size_t most_models = 20;

std::string counted(std::size_t count, const char* one) { return fmt::format("{} {}{}", count, one, count == 1 ? "" : "s"); }

/// "each line is factorised: fewer than 12 lines"
std::string way_text(const ModelUse& use) {
  switch (use.way) {
    case ModelWay::modes:
      return "sum over modes";
    case ModelWay::full:
      return "each line is factorised as a full matrix";
    case ModelWay::factorised:
      return "each line is factorised: " + use.reason;
    case ModelWay::reduced:
      break;
  }
  return "reduced basis";
}

std::string planned_way(const ModelUse& use) {
  if (use.way != ModelWay::reduced) return way_text(use);
  return fmt::format("reduced basis, shifts until the estimated error is at most {:.0e} of the largest FRF of a line", use.bound);
}

std::string expected(const ModelUse& use) {
  if (use.expected_bytes == 0.0) return "";
  std::string text = use.expected_vectors > 0 ? fmt::format("{} vectors, ", use.expected_vectors) : "";
  return text + fmt::format("{:.2g} MB, {:.2g} s", use.expected_bytes / 1e6, use.expected_seconds);
}

std::string used_way(const ModelUse& use) {
  std::string text = way_text(use);
  if (use.vectors > 0) {
    text += fmt::format(" of {}, {}; estimated error {:.1e} of the largest FRF of a line (bound {:.0e}{}), worst at {} Hz",
                        counted(use.vectors, "vector"), counted(use.shifts, "shift"), use.error, use.bound,
                        use.error > use.bound ? ": more vectors make it no less" : "", number(use.worst_hz));
  }
  if (use.reduced_lines > 0) text += "; " + counted(use.reduced_lines, "line");
  if (use.factorizations > 0) text += "; " + counted(use.factorizations, "factorisation");
  return text;
}

std::string more(const std::vector<ident::UsedModel>& models) {
  return models.size() > most_models ? fmt::format("  {} more models: --json\n", models.size() - most_models) : "";
}

}  // namespace

std::string planned_models_text(const std::vector<ident::UsedModel>& models) {
  if (models.empty()) return "";
  Table table({{"file", Align::left}, {"coordinates"}, {"FRFs", Align::left}, {"expected, about", Align::left}});
  for (std::size_t i = 0; i < std::min(most_models, models.size()); ++i) {
    const auto& [file, use] = models[i];
    table.add({file, fmt::format("{}", use.coordinates), planned_way(use), expected(use)});
  }
  return "\nmodels\n" + table.text() + more(models);
}

std::string used_models_text(const std::vector<ident::UsedModel>& models) {
  if (models.empty()) return "";
  Table table({{"file", Align::left}, {"coordinates"}, {"FRFs", Align::left}});
  for (std::size_t i = 0; i < std::min(most_models, models.size()); ++i) {
    const auto& [file, use] = models[i];
    table.add({file, fmt::format("{}", use.coordinates), used_way(use)});
  }
  return "\nmodels\n" + table.text() + more(models);
}

}  // namespace jointid::report
