#include "cli/report/solve_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/report/page.hpp"
#include "cli/report/solve_plots.hpp"
#include "cli/table.hpp"

namespace jointid::cli::report {
namespace {

constexpr std::size_t most_frfs = 16, most_points = 2400, most_line_counts = 400;
constexpr std::size_t widest_matrix = 48;  ///< a wider one is no reading matter

std::string words(std::string key) {
  for (char& c : key) c = c == '_' ? ' ' : c;
  return key;
}

void add_summary(const ident::Solution& solution, ReportPage& page) {
  std::vector<std::string> equations;
  for (const auto equation : solution.used.equations) equations.push_back(ident::name(equation));
  const ident::Fit& fit = solution.fit;
  const ident::RunTime& time = solution.runtime_s;
  page.section("Summary");
  if (!solution.message.empty()) page.add(Text{solution.message});
  page.add(Facts{{{"status", words(ident::name(solution.status))},
                  {"method", ident::name(solution.used.method)},
                  {"equations", fmt::format("{}", fmt::join(equations, " "))},
                  {"weighting", weighting::name(solution.used.weighting)},
                  {"delta", fmt::format("{:g}", solution.used.delta)},
                  {"solver", solution.used.solver},
                  {"frequency lines", fmt::format("{}", fit.lines)},
                  {"equations used", fmt::format("{}", fit.equations_used)},
                  {"equations dropped", fmt::format("{}", fit.equations_dropped)},
                  {"rank", fmt::format("{} of {}", fit.rank, solution.unknowns.size())},
                  {"condition", number(fit.condition)},
                  {"assembly FRF error", fit.asm_frf_error ? number(*fit.asm_frf_error) + " dB" : "–"},
                  {"run time", fmt::format("{:.3g} s", time.total)},
                  {"read, assemble, solve", fmt::format("{:.2g}, {:.2g}, {:.2g} s", time.read, time.assemble, time.solve)}}});
}

void add_unknowns(const ident::Solution& solution, ReportPage& page) {
  if (solution.unknowns.empty()) return;
  Bars bars;
  for (const ident::Estimate& estimate : solution.unknowns) {
    bars.bars.push_back({estimate.name, estimate.value, estimate.unit, estimate.ci95, std::nullopt,
                         estimate.determined ? "" : "not determined by the data"});
  }
  page.section("Identified values");
  page.add(bars);
  page.add(Text{"Bars of one matrix and unit share a scale; the thin line is zero, the bracket a 95 % interval.", true});
}

void add_matrices(const ident::Plan& plan, const ident::Solution& solution, ReportPage& page) {
  if (solution.bands.empty() || solution.dofs.size() > widest_matrix) return;
  page.section("Joint matrices");
  std::vector<std::string> names;
  for (const frf::Dof& dof : solution.dofs) names.push_back(dof.name());
  for (const ident::BandMatrices& band : solution.bands) {
    const std::string where =
        band.band_hz ? fmt::format(", {:g} to {:g} Hz", (*band.band_hz)[0], (*band.band_hz)[1]) : "";
    for (const auto& [kind, rows] : band.matrices) {
      const auto truth = plan.scene.truth.find(kind);
      page.add(MatrixTable{fmt::format("{} {}{}", words(restrictions::key(kind)), restrictions::symbol(kind), where),
                           names, rows, truth == plan.scene.truth.end() ? ident::Matrix() : truth->second});
    }
  }
  page.add(Text{plan.scene.truth.empty() ? "SI units." : "SI units; below each element its deviation from the truth.", true});
}

void add_quality(ident::Plan& plan, const ident::Solution& solution, const ident::Control& control, ReportPage& page) {
  if (solution.quality.empty()) return;
  Table table{{"matrix", "RJCF", "ARVF", "rms relative error"}, {}};
  for (const auto& [kind, figures] : solution.quality) {
    table.rows.push_back({words(restrictions::key(kind)), number(figures.rjcf), number(figures.arvf),
                          number(figures.rms_relative_error)});
  }
  page.section("Against the truth");
  page.add(table);
  page.add(quality_plots(ident::quality_by_line(plan, most_line_counts, control)));
}

void add_frfs(ident::Plan& plan, const ident::Solution& solution, const ident::Control& control, ReportPage& page) {
  if (solution.bands.empty()) return;
  const auto entries = ident::choose_entries(plan, most_frfs);
  const ident::Regenerated regenerated = ident::regenerate(plan, solution.bands, entries, control);
  const PlotGroup overlay = frf_overlay(
      regenerated, {plan.lines.front().frequency_hz, plan.lines.back().frequency_hz}, most_points);
  if (overlay.choices.empty()) return;
  page.section("Assembly: measured and regenerated from the identified joint");
  page.add(overlay);
  page.add(Text{"Shaded: the frequencies that the joint was identified from. In brackets behind a name: rms difference over all lines.",
                true});
  if (regenerated.frequency_hz.size() > most_points) {
    page.add(Text{fmt::format("{} lines are drawn with at most {} points; every peak is kept.",
                              regenerated.frequency_hz.size(), most_points),
                  true});
  }
}

void add_plan(const ident::Plan& plan, ReportPage& page) {
  if (plan.notes.empty() && plan.left_out.empty()) return;
  page.section("Notes");
  for (const std::string& note : plan.notes) page.add(Text{note});
  if (!plan.left_out.empty()) page.add(Text{fmt::format("Left out: {}.", fmt::join(plan.left_out, "; ")), true});
}

}  // namespace

std::string solve_report(ident::Plan& plan, const ident::Solution& solution, const ident::Control& control) {
  const std::string file = plan.scene.file.filename().string();
  ReportPage page(plan.scene.title.empty() ? file : plan.scene.title, "jointid solve " + file);
  add_summary(solution, page);
  add_unknowns(solution, page);
  add_matrices(plan, solution, page);
  add_quality(plan, solution, control, page);
  add_frfs(plan, solution, control, page);
  add_plan(plan, page);
  return page.html();
}

}  // namespace jointid::cli::report
