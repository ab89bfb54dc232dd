#include <fmt/format.h>

#include "cli/stability/stability_report.hpp"

namespace jointid::cli {

std::string stability_text(const StabilityReport& report) {
  std::string text = report.interrupted ? "INTERRUPTED: only what was measured so far\n\n" : "";
  for (const stability::Sweep& sweep : stability::sweeps()) {
    const auto rows = report.of(sweep.name);
    if (rows.empty()) continue;
    text += fmt::format("{}: {}; digits kept\n{}\ncost and outcome\n{}\n", sweep.name, sweep.title,
                        digits_table(sweep, rows).text(), cost_table(rows).text());
  }
  text +=
      "digits: of the unknowns, each times the norm of its column, against the same identification of the same FRFs in 50 digits\n"
      "digits true: of the worst unknown over the largest, against the truth; stated: by the solution\n\n"
      "what solutions state of themselves\n" +
      verdict_table(report).text();
  if (report.count.scenes > 0) text += fmt::format("  random scenes of seed {}\n", report.seed);
  text +=
      "  silent wrong: off by more than 10 times the stated bound, without status or warning\n"
      "  false alarm: status or warning, though right to 6 digits\n";
  return text;
}

}  // namespace jointid::cli
