#include "report/result/solve_page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "report/frf_curves.hpp"
#include "report/page/heat_map.hpp"
#include "report/page/limits.hpp"
#include "report/page/page.hpp"
#include "report/page/solve_plots.hpp"
#include "report/page/status_banner.hpp"
#include "report/text/admissibility_text.hpp"
#include "report/text/identifiability_text.hpp"
#include "report/text/joints_text.hpp"
#include "report/text/systematic_text.hpp"
#include "report/text/table.hpp"
#include "report/text/words.hpp"

namespace jointid::report {
namespace {

/// More is no reading matter; the JSON has it.
constexpr std::size_t most_bars = 1000, most_elements = 10000;
/// Values on the first screen.
constexpr std::size_t most_first = 8;
/// FRFs in the list of those that are met worst.
constexpr std::size_t most_worst = 20;

std::string duration(double seconds) {
  return seconds < 1.0 ? fmt::format("{:.3g} ms", 1e3 * seconds) : fmt::format("{:.3g} s", seconds);
}

std::vector<SuspectLines> suspect_lines(const ident::Solution& solution) {
  std::vector<SuspectLines> out;
  if (!solution.check || solution.check->verdict == ident::Verdict::clean) return out;
  for (const ident::Suspect& suspect : solution.check->suspects) {
    out.push_back({ident::name(suspect.kind), suspect.file, dofs_text(suspect), suspect.evidence, suspect.remedy});
  }
  return out;
}

/// Why a solution is what its status says; of `ok` without a message what its residuals say.
std::string reason_of(const ident::Solution& solution) {
  if (!solution.message.empty() || solution.status != ident::Status::ok) return solution.message;
  const ident::Fit& fit = solution.fit;
  if (fit.chi_square) {
    return "The noise of the FRFs explains the residuals: χ² / degrees of freedom " + chi_square_text(*fit.chi_square) + ".";
  }
  if (fit.misfit) return fmt::format("The residuals are {:.3g} times what the noise of the FRFs explains.", std::sqrt(*fit.misfit));
  return "Nothing in the data contradicts the answer.";
}

void add_status(const ident::Solution& solution, ReportPage& page) {
  page.status(status_banner(ident::name(solution.status), reason_of(solution), solution.warnings, suspect_lines(solution)));
}

void add_summary(const ident::Solution& solution, ReportPage& page) {
  const ident::Fit& fit = solution.fit;
  const ident::RunTime& time = solution.runtime_s;
  page.section("Summary");
  Facts facts{{{"status", words(ident::name(solution.status))},
               {"method", ident::name(solution.used.method)},
               {"equations", equations_text(solution.used.equations)},
               {"weighting", weighting_text(solution.used.method, solution.used.weighting)},
               {"delta", delta_text(solution.used.method, solution.used.delta)},
               {"solver", solution.used.solver},
               {"frequency lines", fmt::format("{}", fit.lines)},
               {"equations used", fmt::format("{}", fit.equations_used)},
               {"equations dropped", fmt::format("{}", fit.equations_dropped)},
               {"rank", fmt::format("{} of {}", fit.rank, solution.unknowns.size())},
               {"condition", fit.chi_square ? "–" : number(fit.condition)},
               {"digits that rounding alone leaves", fit.digits ? rounding_digits(solution) : "–"},
               {"residuals over what noise explains", fit.misfit ? fmt::format("{:.3g}", std::sqrt(*fit.misfit)) : "–"},
               {"iterations", fit.iterations > 0 ? fmt::format("{}", fit.iterations) : "–"},
               {"χ² / degrees of freedom", fit.chi_square ? chi_square_text(*fit.chi_square) : "–"},
               {"outlier lines", fit.chi_square ? fmt::format("{}", fit.chi_square->outlying_lines) : "–"},
               {"assembly FRF error", fit.asm_frf_error ? number(*fit.asm_frf_error) + " dB" : "–"},
               {"run time", duration(time.total)}}};
  for (const auto& [phase, seconds] : ident::run_time_phases) {
    if (time.*seconds > 0.0) facts.rows.push_back({fmt::format("run time, {}", phase), duration(time.*seconds)});
  }
  page.add(facts);
}

/// Values first … last − 1, of those that may be shown.
void add_values(const ident::Solution& solution, std::size_t first, std::size_t last, ReportPage& page) {
  Bars bars;
  for (std::size_t i = first; i < std::min(last, solution.unknowns.size()); ++i) {
    const ident::Estimate& estimate = solution.unknowns[i];
    bars.bars.push_back({estimate.name, estimate.value, estimate.unit, estimate.ci95, std::nullopt,
                         remark_on(estimate), estimate.error_estimate});
  }
  page.add(bars);
  const bool intervals = std::ranges::any_of(bars.bars, [](const Bar& bar) { return bar.interval.has_value(); });
  page.add(Text{intervals ? "Bars of one matrix and unit share a scale; the brackets are 95 % intervals."
                          : "Bars of one matrix and unit share a scale. This method states no intervals.",
                true});
}

/// As many as leave room for the worst FRF on the first screen; of many joints a line for each of the worst.
void add_first_values(const ident::Solution& solution, ReportPage& page) {
  if (solution.unknowns.empty()) return;
  if (is_shown_by_joint(solution)) {
    page.section("Identified joints");
    page.add(joints_table(solution), joints_head(solution));
    page.add(Text{"Of each joint the largest values, and the unknown with the largest error over its value; --json and --csv write all.",
                  true});
    return;
  }
  page.section("Identified values");
  add_values(solution, 0, most_first, page);
}

void add_other_values(const ident::Solution& solution, ReportPage& page) {
  if (solution.unknowns.size() <= most_first || is_shown_by_joint(solution)) return;
  page.section("Further identified values");
  add_values(solution, most_first, most_bars, page);
  if (solution.unknowns.size() > most_bars) {
    page.add(Text{fmt::format("First {} of {} unknowns; --json and --csv write all of them.", most_bars, solution.unknowns.size())});
  }
}

void add_constraints(const ident::Solution& solution, ReportPage& page) {
  if (!solution.admissibility) return;
  page.section("Constraints");
  page.add(constraints_table(*solution.admissibility));
  page.add(Text{constraints_sum(*solution.admissibility) + ".", true});
}

void add_identifiability(const ident::Solution& solution, ReportPage& page) {
  if (!solution.identifiability) return;
  page.section("Identifiability");
  for (const ident::Finding& finding : solution.identifiability->findings) page.add(Text{finding.text});
  page.add(Facts{visibility_rows(solution)});
  page.add(weakest_table(solution.identifiability->weakest), "Least determined combinations, relative to the estimates");
}

void add_systematic(const ident::Solution& solution, ReportPage& page) {
  if (solution.systematic.empty()) return;
  page.section("Gains, delays and masses");
  page.add(systematic_table(solution.systematic), "Estimated with the joint");
  if (!solution.identifiability) return;
  page.add(calibration_table(solution.identifiability->calibration),
           "Share of the variance that exact knowledge of these would remove: of all together, of the most important one");
}

void add_matrices(const ident::Plan& plan, const ident::Solution& solution, const Display& display, ReportPage& page) {
  if (solution.bands.empty()) return;
  page.section("Joint matrices");
  const std::size_t n = solution.dofs.size();
  if (solution.bands.size() * plan.restriction.matrices.size() * n * n > most_elements) {
    page.add(Text{"Too large to show here; --json writes them."});
    return;
  }
  const std::vector<std::string> names = frf::names(solution.dofs);
  const ident::Matrices truths = in_units_of(display, plan.scene.truth, solution.dofs);
  for (const ident::BandMatrices& band : solution.bands) {
    const std::string where =
        band.band_hz ? fmt::format(", {:g} to {:g} Hz", (*band.band_hz)[0], (*band.band_hz)[1]) : "";
    for (const auto& [kind, rows] : band.matrices) {
      const auto truth = truths.find(kind);
      const auto errors = band.errors.find(kind);
      page.add(MatrixTable{fmt::format("{} {}{}", words(restrictions::key(kind)), restrictions::symbol(kind), where),
                           names, rows, truth == truths.end() ? ident::Matrix() : truth->second,
                           errors == band.errors.end() ? ident::Matrix() : errors->second});
    }
  }
  page.add(Text{units_text(display) + (truths.empty() ? "." : "; below each element its deviation from the truth."), true});
}

void add_quality(const ident::Solution& solution, const tasks::SolutionDetails& details, ReportPage& page) {
  if (solution.quality.empty()) return;
  Table table({{"matrix", Align::left}, {"RJCF"}, {"ARVF"}, {"rms relative error"}});
  for (const auto& [kind, figures] : solution.quality) {
    table.add({words(restrictions::key(kind)), number(figures.rjcf), number(figures.arvf),
               number(figures.rms_relative_error)});
  }
  page.section("Against the truth");
  page.add(table);
  page.add(quality_plots(details.quality));
}

/// An unknown that still moves while the objective no longer falls is not determined.
void add_iterations(const tasks::UnknownsByIteration& found, ReportPage& page) {
  const PlotGroup plots = iteration_plots(found);
  if (plots.choices.empty()) return;
  page.section("Over the iterations");
  page.add(plots);
  page.add(Text{
      "An unknown that still moves while the objective no longer falls is not determined by the data. --by-iteration writes all.",
      true});
}

/// What the data's own errors explain is about 1; far above it the model, or the FRF, is wrong.
void add_noise_map(const tasks::EntryErrors& errors, ReportPage& page) {
  if (errors.rms_noise.empty()) return;
  HeatMap map = error_map("rms error in units of noise, responses down, references across", errors.responses, errors.references,
                          errors.rms_noise);
  if (tasks::worst_first(map.values).empty()) return;
  map.unit = HeatUnit::noise;
  page.add(map);
  page.add(Text{"In standard deviations σ of the measured assembly FRF: about 1 where its noise explains the error. The synthesised FRF "
                "has the noise of the substructures' FRFs beside it.", true});
}

void add_frf_errors(const tasks::EntryErrors& errors, ReportPage& page) {
  const HeatMap map = error_map("rms error in dB, responses down, references across", errors.responses, errors.references, errors.rms_db);
  if (tasks::worst_first(map.values).empty()) return;
  page.section("Errors of all assembly FRFs");
  page.add(map);
  if (errors.responses.size() < errors.all_responses || errors.references.size() < errors.all_references) {
    page.add(Text{fmt::format("An even selection of {} of {} responses and {} of {} references.", errors.responses.size(),
                              errors.all_responses, errors.references.size(), errors.all_references)});
  }
  page.add(worst_frfs(map), "Worst first", {most_worst, "the map has all of them"});
  page.add(
      Text{fmt::format("rms over all {} lines that both systems have. A conspicuous row points to its sensor, a column to its "
                       "excitation.",
                       errors.lines),
           true});
  add_noise_map(errors, page);
}

/// The FRFs of the assembly that are drawn, measured and synthesised.
PlotGroup overlay_of(const ident::Plan& plan, const tasks::SolutionDetails& details, const Display& display) {
  if (details.regenerated.frfs.empty()) return {};
  const std::array used_hz = {plan.lines.front().frequency_hz, plan.lines.back().frequency_hz};
  return frf_overlay(details.regenerated, details.all_used ? std::nullopt : std::optional(used_hz), most_points, display);
}

/// Magnitude of the FRF that is met worst, of those that are drawn.
void add_worst(const tasks::EntryErrors& errors, const PlotGroup& overlay, ReportPage& page) {
  const std::vector<std::size_t> order = tasks::worst_first(errors.rms_db);
  if (order.empty()) return;
  const std::size_t columns = errors.references.size();
  const std::string name = errors.responses[order[0] / columns].name() + " / " + errors.references[order[0] % columns].name();
  const auto worst = std::ranges::find_if(overlay.choices, [&](const Choice& choice) { return choice.name.starts_with(name + " ("); });
  if (worst == overlay.choices.end()) return;
  page.section("Worst FRF, measured and synthesised");
  page.add(PlotGroup{"FRF", {{worst->name, {worst->plots.front()}}}});
  page.add(Text{fmt::format("{} is met worst of {}; in brackets the rms difference of the magnitudes.", worst->name, order.size()), true});
}

void add_frfs(const tasks::SolutionDetails& details, const PlotGroup& overlay, ReportPage& page) {
  const auto& [errors, regenerated, all_used, quality, iterations] = details;
  if (overlay.choices.empty()) return;
  page.section("Assembly: measured, and synthesised from the identified joint");
  page.add(overlay);
  page.add(Text{"In brackets behind a name: rms difference of the magnitudes over all lines.", true});
  if (!all_used) page.add(Text{"Shaded: from the first to the last line that the joint was identified from.", true});
  if (const std::string cut = drawn_text(overlay.choices.size(), errors.all_responses * errors.all_references); !cut.empty()) {
    page.add(Text{cut, true});
  }
  if (regenerated.frequency_hz.size() > most_points) {
    page.add(Text{fmt::format("{} lines are drawn with at most {} points; every peak is kept.",
                              regenerated.frequency_hz.size(), most_points),
                  true});
  }
  add_frf_errors(errors, page);
}

void add_plan(const ident::Plan& plan, ReportPage& page) {
  if (plan.warnings.empty() && plan.notes.empty() && plan.left_out.empty()) return;
  page.section("Notes");
  for (const std::string& warning : plan.warnings) page.add(Text{warning});
  for (const std::string& note : plan.notes) page.add(Text{note});
  if (!plan.left_out.empty()) page.add(Text{fmt::format("Left out: {}.", fmt::join(plan.left_out, "; ")), true});
}

}  // namespace

std::string solve_report(const ident::Plan& plan, const ident::Solution& solution, const tasks::SolutionDetails& details,
                         const Display& display) {
  const std::string file = plan.scene.file.filename().string();
  const ident::Solution shown = in_units_of(display, solution);
  const PlotGroup overlay = overlay_of(plan, details, display);
  ReportPage page(plan.scene.title.empty() ? file : plan.scene.title, "jointid solve " + file);
  add_status(solution, page);
  add_first_values(shown, page);
  add_worst(details.errors, overlay, page);
  add_summary(solution, page);
  add_other_values(shown, page);
  add_constraints(solution, page);
  add_systematic(solution, page);
  add_identifiability(solution, page);
  add_matrices(plan, shown, display, page);
  add_quality(solution, details, page);
  add_iterations(details.iterations, page);
  add_frfs(details, overlay, page);
  add_plan(plan, page);
  return page.html();
}

}  // namespace jointid::report
