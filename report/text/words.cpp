#include "report/text/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace jointid::report {

std::string words(std::string key) {
  std::ranges::replace(key, '_', ' ');
  return key;
}

std::string equations_text(const std::vector<ident::Equation>& equations) {
  std::vector<std::string> names;
  for (const auto equation : equations) names.push_back(ident::name(equation));
  return names.empty() ? "all" : fmt::format("{}", fmt::join(names, " "));
}

namespace {

/// A third of the lines at most is set aside.
bool is_set_aside(const ident::ChiSquare& chi_square) {
  const auto lines = std::ranges::count_if(chi_square.by_line, [](double ratio) { return !std::isnan(ratio); });
  return 3 * static_cast<std::ptrdiff_t>(chi_square.outlying_lines) <= lines;
}

}  // namespace

std::string chi_square_text(const ident::ChiSquare& chi_square) {
  const auto [value, freedom] = std::pair(chi_square.value, chi_square.degrees_of_freedom);
  const std::string aside =
      chi_square.outlying_lines == 0 ? "" : fmt::format(", {} outlier lines set aside", chi_square.outlying_lines);
  return fmt::format("{:.4g} / {:g} = {:.4g}{}", value, freedom, value / freedom, is_set_aside(chi_square) ? aside : "");
}

std::string remark_on(const ident::Estimate& unknown) {
  if (!unknown.determined) return "not determined by the data";
  if (!unknown.limit.empty()) return unknown.limit;
  const double error = unknown.std_error ? *unknown.std_error : unknown.error_estimate.value_or(0.0);
  return error > 0.0 && error >= std::abs(unknown.value) ? "error as large as the value" : "";
}

std::string rounding_digits(const ident::Solution& solution) {
  std::map<std::string, double> largest, error;  // per unit
  for (const ident::Estimate& estimate : solution.unknowns) {
    largest[estimate.unit] = std::max(largest[estimate.unit], std::abs(estimate.value));
    error[estimate.unit] = std::max(error[estimate.unit], estimate.error_estimate.value_or(0.0));
  }
  double worst = 0.0;
  for (const auto& [unit, size] : largest) worst = std::max(worst, size > 0.0 ? error[unit] / size : 0.0);
  const double left = worst > 0.0 ? std::max(0.0, -std::log10(worst)) : HUGE_VAL;
  if (!(left < *solution.fit.digits)) return fmt::format("{:.1f}", *solution.fit.digits);
  return fmt::format("{:.1f}, of which the noise leaves {:.1f}", *solution.fit.digits, left);
}

std::string dofs_text(const ident::Suspect& suspect) {
  return fmt::format("{}", fmt::join(frf::names(suspect.dofs), ", "));
}

std::string weighting_text(ident::Method method, weighting::Weighting weighting) {
  return ident::weighs_equations(method) ? weighting::name(weighting) : "–";
}

std::string delta_text(ident::Method method, double delta) {
  return ident::weighs_equations(method) ? fmt::format("{:g}", delta) : "–";
}

std::string method_text(ident::Method method, const std::vector<ident::Equation>& equations, weighting::Weighting weighting,
                        double delta, const std::string& solver) {
  const std::string weights = ident::weighs_equations(method)
                                  ? fmt::format("weighting {}, delta {:g}, ", weighting::name(weighting), delta)
                                  : std::string();
  return fmt::format("{}, equations {}, {}solver {}", ident::name(method), equations_text(equations), weights, solver);
}

std::string phrases(const char* title, const std::vector<std::string>& list) {
  if (list.empty()) return "";
  std::string text = fmt::format("\n{}\n", title);
  for (const std::string& phrase : list) text += "  " + phrase + "\n";
  return text;
}

}  // namespace jointid::report
