#include "report/text/identifiability_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "ident/likelihood/findings/findings.hpp"

namespace jointid::report {
namespace {

std::string times(const std::optional<double>& value) { return value ? fmt::format("{:.3g}", *value) : "–"; }

}  // namespace

std::string interval_words(ident::IntervalKind kind) {
  switch (kind) {
    case ident::IntervalKind::cramer_rao:
      return "Cramér–Rao bound";
    case ident::IntervalKind::bootstrap:
      return "parametric bootstrap";
    case ident::IntervalKind::sandwich:
      return "sandwich covariance";
    case ident::IntervalKind::none:
      break;
  }
  return "–";
}

Table weakest_table(const std::vector<ident::WeakCombination>& weakest) {
  Table table({{"least determined", Align::left}, {"to"}, {"best determined of these", Align::left}, {"to"}, {"correlation"}});
  for (const ident::WeakCombination& weak : weakest) {
    table.add({ident::text(weak.worst), percent(weak.worst.deviation), weak.best ? ident::text(*weak.best) : "",
               weak.best ? percent(weak.best->deviation) : "",
               weak.correlation ? fmt::format("{:.4f}", *weak.correlation) : ""});
  }
  return table;
}

std::vector<std::pair<std::string, std::string>> visibility_rows(const ident::Solution& solution) {
  const ident::Identifiability& found = *solution.identifiability;
  const bool errors = !std::isnan(found.largest_relative_error);
  return {{"standard errors and intervals", interval_words(solution.intervals)},
          {"largest relative standard error", errors ? percent(found.largest_relative_error) : "–"},
          {"median of |H_sub - H_asm| over its error", times(found.joint.effect)},
          {"work of the least determined combination, assembled over free parts", times(found.joint.deformation)}};
}

std::string identifiability_text(const ident::Solution& solution) {
  if (!solution.identifiability) return "";
  Table facts({{"", Align::left}, {"", Align::left}});
  for (const auto& [name, value] : visibility_rows(solution)) facts.add({name, value});
  std::string text = "\nidentifiability\n" + facts.text();
  if (!solution.identifiability->weakest.empty()) {
    text +=
        "\nleast determined combinations, relative to the estimates\n" + weakest_table(solution.identifiability->weakest).text();
  }
  for (const ident::Finding& finding : solution.identifiability->findings) text += "\n" + finding.text + "\n";
  return text;
}

}  // namespace jointid::report
