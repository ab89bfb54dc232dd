#include "report/text/admissibility_text.hpp"

#include <fmt/format.h>

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

}  // namespace jointid::report
