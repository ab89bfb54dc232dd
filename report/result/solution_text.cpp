#include "report/result/solution_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "report/text/admissibility_text.hpp"
#include "report/text/identifiability_text.hpp"
#include "report/text/joints_text.hpp"
#include "report/text/systematic_text.hpp"
#include "report/text/table.hpp"
#include "report/text/models_text.hpp"
#include "report/text/variances_text.hpp"
#include "report/text/words.hpp"

namespace jointid::report {
namespace {

std::string number_or_dash(const std::optional<double>& value) { return value ? number(*value) : "–"; }

/// Suspects of a check, most likely first, with the scene lines that would mend them.
void add_suspects(const std::vector<ident::Suspect>& suspects, Table& table) {
  constexpr std::size_t most = 5;
  for (std::size_t i = 0; i < std::min(most, suspects.size()); ++i) {
    const ident::Suspect& suspect = suspects[i];
    table.add({"suspect", ident::title(suspect) + ": " + suspect.evidence});
    std::string remedy = suspect.remedy;
    std::ranges::replace(remedy, '\n', ' ');
    if (!remedy.empty()) table.add({"  remedy", remedy});
  }
}

std::string head(const ident::Solution& solution, const std::string& title) {
  const ident::Used& used = solution.used;
  Table table({{"", Align::left}, {"", Align::left}});
  table.add({"status", words(ident::name(solution.status))});
  if (!solution.message.empty()) table.add({"message", solution.message});
  for (const std::string& warning : solution.warnings) table.add({"warning", warning});
  if (solution.check && solution.check->verdict != ident::Verdict::clean) add_suspects(solution.check->suspects, table);
  if (!used.chosen.empty()) table.add({"chosen", used.chosen});
  table.add({"method", method_text(used.method, used.equations, used.weighting, used.delta, used.solver)});
  return (title.empty() ? "" : title + "\n") + table.text();
}

/// Springs between many coordinates: pages of zeros, whose few numbers are the unknowns.
bool is_mostly_zeros(const ident::Matrix& rows) {
  constexpr std::size_t widest = 16, share = 4;
  std::size_t others = 0;
  for (const auto& row : rows) others += row.size() - static_cast<std::size_t>(std::ranges::count(row, 0.0));
  return rows.size() > widest && share * others < rows.size() * rows.size();
}

/// `errors`: of the elements, or null.
std::string matrix_text(const std::vector<frf::Dof>& dofs, const ident::Matrix& rows, const ident::Matrix* errors) {
  if (is_mostly_zeros(rows))
    return fmt::format("  {0} × {0}, mostly zeros: see the unknowns below; in full by --json and --report\n", rows.size());
  std::vector<Column> columns = {{"", Align::left}};
  for (const auto& dof : dofs) columns.push_back({dof.name(), Align::right});
  Table table(std::move(columns));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::vector<std::string> cells = {dofs.at(i).name()};
    for (std::size_t j = 0; j < rows[i].size(); ++j) {
      cells.push_back(number(rows[i][j], errors == nullptr ? std::nullopt : std::optional((*errors)[i][j])));
    }
    table.add(std::move(cells));
  }
  return table.text();
}

std::string matrices_text(const ident::Solution& solution, const std::string& units) {
  std::string text;
  for (const auto& band : solution.bands) {
    const std::string where = band.band_hz ? fmt::format(", {:g} to {:g} Hz", (*band.band_hz)[0], (*band.band_hz)[1]) : "";
    for (const auto& [kind, rows] : band.matrices) {
      text += fmt::format("\n{} {} ({}){}\n", words(restrictions::key(kind)), restrictions::symbol(kind), units, where);
      const auto errors = band.errors.find(kind);
      text += matrix_text(solution.dofs, rows, errors == band.errors.end() ? nullptr : &errors->second);
    }
  }
  return text;
}

std::string interval(const ident::Estimate& estimate) {
  return estimate.ci95 ? number((*estimate.ci95)[0]) + " … " + number((*estimate.ci95)[1]) : "–";
}

std::string short_number(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? fmt::format("{:.2g}", *value) : "–";
}

/// What the error estimates of a linear method are.
std::string estimate_note(const ident::Solution& solution) {
  if (solution.used.method == ident::Method::newton) {
    return "  error estimate: scatter of the lines, to first order" +
           std::string(std::ranges::any_of(solution.unknowns, [](const auto& u) { return u.bias.has_value(); })
                           ? ", and the difference to the joint with each FRF weighed by its noise\n"
                           : "; the bias that noise in the parts' FRFs makes is not known and not in it\n");
  }
  const bool bias = std::ranges::any_of(solution.unknowns, [](const auto& u) { return u.bias.has_value(); });
  return bias ? "  error estimate: scatter between groups of lines, and the bias that noise in the coefficients makes, to first "
                "order; of H1 from coherences its bias, too\n"
              : "  error estimate: scatter between groups of lines; the bias that noise in the coefficients makes is not known "
                "and not in it\n";
}

/// Columns of errors only where a method has them.
std::string unknowns_text(const ident::Solution& solution) {
  const bool errors = std::ranges::any_of(solution.unknowns, [](const auto& u) { return u.std_error || u.ci95; });
  const bool estimates = std::ranges::any_of(solution.unknowns, [](const auto& u) { return u.error_estimate.has_value(); });
  std::vector<Column> columns = {{"name", Align::left}, {"value"}, {"unit", Align::left}};
  if (errors) columns.insert(columns.end(), {{"std error"}, {"95 % interval"}});
  if (estimates) columns.push_back({"error estimate"});
  columns.push_back({"", Align::left});
  Table table(std::move(columns));
  for (const auto& estimate : solution.unknowns) {
    std::vector<std::string> cells = {estimate.name, number(estimate.value, estimate.error_estimate), estimate.unit};
    if (errors) cells.insert(cells.end(), {number_or_dash(estimate.std_error), interval(estimate)});
    if (estimates) cells.push_back(short_number(estimate.error_estimate));
    cells.push_back(remark_on(estimate));
    table.add(std::move(cells));
  }
  const bool none = !estimates && !errors && solution.used.method == ident::Method::newton;
  return "\nunknowns\n" + table.text() + (estimates ? estimate_note(solution) : "") +
         (none ? "  no errors: only a joint that converged and that the data determine has them\n" : "");
}

std::string fit_text(const ident::Solution& solution) {
  const ident::Fit& fit = solution.fit;
  Table table({{"", Align::left}, {""}});
  table.add({"frequency lines", fmt::format("{}", fit.lines)});
  table.add({"equations used", fmt::format("{}", fit.equations_used)});
  table.add({"equations dropped", fmt::format("{}", fit.equations_dropped)});
  table.add({"rank", fmt::format("{}", fit.rank)});
  if (!fit.chi_square) table.add({"condition", number(fit.condition)});
  if (fit.digits) table.add({"digits that rounding alone leaves", rounding_digits(solution)});
  if (fit.iterations > 0) table.add({"iterations", fmt::format("{}", fit.iterations)});
  if (fit.chi_square) {
    table.add({"χ² / degrees of freedom", chi_square_text(*fit.chi_square)});
    table.add({"outlier lines", fmt::format("{}", fit.chi_square->outlying_lines)});
  }
  if (fit.misfit) table.add({"residuals over their expected noise", fmt::format("{:.3g}", std::sqrt(*fit.misfit))});
  table.add({"assembly FRF error, dB", number_or_dash(fit.asm_frf_error)});
  return "\nfit\n" + table.text();
}

std::string verdict(const ident::MinimumSearch& search) {
  if (search.minima.empty()) return "no start converged";
  if (search.equally_good == 1) return "unique among the minima found";
  return fmt::format("{} minima fit equally well: the data do not determine which is the joint", search.equally_good);
}

/// Minima of several starts, best first; those that fit equally well with their unknowns.
std::string search_text(const ident::Solution& solution) {
  if (!solution.search) return "";
  constexpr std::size_t most = 10;
  const ident::MinimumSearch& search = *solution.search;
  Table table({{"minimum"}, {"cost"}, {"starts"}});
  for (std::size_t i = 0; i < std::min(most, search.minima.size()); ++i) {
    table.add({fmt::format("{}", i + 1), number(search.minima[i].cost), fmt::format("{}", search.minima[i].starts)});
  }
  std::string text = "\nminima: " + verdict(search) + "\n" + table.text();
  for (std::size_t i = 1; i < std::min(most, search.equally_good); ++i) {
    text += fmt::format("  {}:", i + 1);
    for (std::size_t u = 0; u < solution.unknowns.size(); ++u)
      text += " " + solution.unknowns[u].name + " = " + number(search.minima[i].values[u]);
    text += "\n";
  }
  return text;
}

std::string quality_text(const std::map<restrictions::Kind, ident::Quality>& by_kind) {
  if (by_kind.empty()) return "";
  Table table({{"matrix", Align::left}, {"RJCF"}, {"ARVF"}, {"rms relative error"}});
  for (const auto& [kind, figures] : by_kind) {
    table.add({words(restrictions::key(kind)), number(figures.rjcf), number(figures.arvf), number(figures.rms_relative_error)});
  }
  return "\nagainst the truth\n" + table.text();
}

std::string time_text(const ident::RunTime& time) {
  std::string phases;
  for (const auto& [phase, seconds] : ident::run_time_phases) {
    if (time.*seconds > 0.0) phases += fmt::format("{}{} {:.3g}", phases.empty() ? "" : ", ", phase, time.*seconds);
  }
  return fmt::format("\nrun time {:.3g} s ({})\n", time.total, phases);
}

}  // namespace

std::string solution_text(const ident::Solution& solution, const std::string& title, const std::string& units) {
  const std::string values =
      is_shown_by_joint(solution) ? joints_text(solution) : matrices_text(solution, units) + unknowns_text(solution);
  return head(solution, title) + values + constraints_text(solution) + loose_text(solution) +
         systematic_text(solution) + identifiability_text(solution) + fit_text(solution) + search_text(solution) +
         variances_text(solution.variances) + used_models_text(solution.models) +
         quality_text(solution.quality) + time_text(solution.runtime_s);
}

std::string unknowns_csv(const ident::Solution& solution) {
  const auto exact = [](const std::optional<double>& value) {
    return value && std::isfinite(*value) ? fmt::format("{}", *value) : std::string();
  };
  std::string csv = csv_line({"name", "value", "unit", "std_error", "ci95_low", "ci95_high", "determined"});
  for (const auto& estimate : solution.unknowns) {
    const auto bound = [&](std::size_t i) { return estimate.ci95 ? exact((*estimate.ci95)[i]) : std::string(); };
    csv += csv_line({estimate.name, exact(estimate.value), estimate.unit, exact(estimate.std_error), bound(0), bound(1),
                     estimate.determined ? "true" : "false"});
  }
  return csv;
}

}  // namespace jointid::report
