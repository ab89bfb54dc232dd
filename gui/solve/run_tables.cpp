#include "gui/solve/run_tables.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/text.hpp"
#include "gui/look/said.hpp"
#include "report/text/words.hpp"

namespace jointid::gui {
namespace {

using ident::Estimate;
using ident::Solution;

struct Figure {
  const char* name;
  std::function<std::string(const Solution&)> text;
};

std::vector<Figure> figures() {
  return {{QT_TRANSLATE_NOOP("Said", "status"), [](const Solution& run) { return report::words(ident::name(run.status)); }},
          {QT_TRANSLATE_NOOP("Said", "way"),
           [](const Solution& run) {
             const ident::Used& used = run.used;
             return report::method_text(used.method, used.equations, used.weighting, used.delta, used.solver);
           }},
          {QT_TRANSLATE_NOOP("Said", "lines"), [](const Solution& run) { return std::to_string(run.fit.lines); }},
          {QT_TRANSLATE_NOOP("Said", "assembly FRF error (dB)"),
           [](const Solution& run) { return run.fit.asm_frf_error ? digits(*run.fit.asm_frf_error, "%.4g") : std::string(); }},
          {QT_TRANSLATE_NOOP("Said", "χ² / degrees of freedom"),
           [](const Solution& run) { return run.fit.chi_square ? report::chi_square_text(*run.fit.chi_square) : std::string(); }},
          {QT_TRANSLATE_NOOP("Said", "run time (s)"), [](const Solution& run) { return digits(run.runtime_s.total, "%.3g"); }}};
}

const Estimate* find(const Solution& solution, const std::string& name) {
  const auto found = std::ranges::find(solution.unknowns, name, &Estimate::name);
  return found == solution.unknowns.end() ? nullptr : &*found;
}

/// Of all runs, those of the front first.
std::vector<std::string> names_of(const std::vector<Solved>& runs, std::size_t front) {
  std::vector<std::string> names;
  const auto add = [&](const Solution& solution) {
    for (const Estimate& estimate : solution.unknowns) {
      if (std::ranges::find(names, estimate.name) == names.end()) names.push_back(estimate.name);
    }
  };
  add(runs[front].solution);
  for (const Solved& run : runs) add(run.solution);
  return names;
}

Cell unknown_cell(const Estimate* estimate, const Estimate* of_front) {
  if (estimate == nullptr) return {};
  std::optional<double> half = estimate->error_estimate;
  if (estimate->ci95) half = ((*estimate->ci95)[1] - (*estimate->ci95)[0]) / 2.0;
  Cell cell{q(digits(estimate->value, "%.5g") + (half ? " ± " + digits(*half, "%.2g") : "") + " " + estimate->unit)};
  if (of_front == nullptr || of_front == estimate || !(std::abs(of_front->value) > 0.0)) return cell;
  const double off = estimate->value / of_front->value - 1.0;
  if (!std::isfinite(off)) return cell;
  cell.hint = Said::tr("%1 of the selected run").arg((off < 0.0 ? "−" : "+") + q(percent(std::abs(off))));
  cell.shade = 0.75 * std::min(1.0, std::abs(off));
  return cell;
}

}  // namespace

CellRows run_rows(const std::vector<Solved>& runs, std::size_t front) {
  CellRows out;
  for (const Solved& run : runs) out.columns << Said::tr("run ") + q(run.name);
  for (const Figure& figure : figures()) {
    out.rows << said(figure.name);
    out.cells.emplace_back();
    for (const Solved& run : runs) out.cells.back().push_back(Cell{q(figure.text(run.solution))});
  }
  for (const std::string& name : names_of(runs, front)) {
    out.rows << q(name);
    out.cells.emplace_back();
    const Estimate* const of_front = find(runs[front].solution, name);
    for (const Solved& run : runs) out.cells.back().push_back(unknown_cell(find(run.solution, name), of_front));
  }
  return out;
}

}  // namespace jointid::gui
