#include "report/text/admissibility_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace jointid::report {

Table constraints_table(const ident::Admissibility& found) {
  Table table({{"constraint", Align::left},
               {"at its limit", Align::left},
               {found.from_variances ? "cost, χ²" : "cost, residual sum / mean square"}});
  for (const auto& [text, size, at_limit, chi_square] : found.constraints) {
    const std::string held = size == 1 ? "yes" : fmt::format("{} of {}", at_limit, size);
    table.add({text, at_limit == 0 ? "no" : held, number(chi_square)});
  }
  return table;
}

std::string constraints_sum(const ident::Admissibility& found) {
  const char* what = found.from_variances ? "χ² rises by" : "the weighted residual sum over its mean square rises by";
  return fmt::format("{} {}, {} equation{} hold{}", what, number(found.chi_square), found.equations, found.equations == 1 ? "" : "s",
                     found.equations == 1 ? "s" : "");
}

std::string constraints_text(const ident::Solution& solution) {
  if (!solution.admissibility) return "";
  return "\nconstraints\n" + constraints_table(*solution.admissibility).text() + "  " + constraints_sum(*solution.admissibility) + "\n";
}

std::string loose_text(const ident::Solution& solution) {
  constexpr std::size_t most = 10;
  if (solution.loose.empty()) return "";
  Table table({{"joint", Align::left}, {"probability"}, {"stiffness lost"}, {"standard error"}, {"loss factor"}});
  const std::size_t shown = std::min(most, solution.loose.size());
  for (std::size_t k = 0; k < shown; ++k) {
    const ident::LooseJoint& each = solution.loose[k];
    table.add({each.joint.empty() ? "the joint" : each.joint, fmt::format("{:.3f}", each.probability),
               number(each.lost, each.std_error), each.std_error ? fmt::format("{:.2g}", *each.std_error) : "–",
               each.loss_factor ? number(*each.loss_factor) : "–"});
  }
  const std::string rest = shown < solution.loose.size()
                               ? fmt::format("  {} more joints are less probably loose\n", solution.loose.size() - shown)
                               : std::string();
  return "\nloose joints, the most probable first\n" + table.text() + rest;
}

}  // namespace jointid::report
