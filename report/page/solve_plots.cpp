#include "report/page/solve_plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ident/result/decibel_error.hpp"
#include "report/decimate.hpp"
#include "report/frf_curves.hpp"
#include "report/page/phase_branch.hpp"
#include "report/text/frf_criteria.hpp"

namespace jointid::report {
namespace {

using Values = std::vector<double>;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();
constexpr double least_deviation_db = 0.1;  ///< a difference of less looks small

bool has_any(const Values& values) {
  return std::ranges::any_of(values, [](double value) { return std::isfinite(value); });
}

double largest(const tasks::RegeneratedFrf& frf) {
  double out = 0.0;
  for (const Complex& value : frf.measured) out = std::fmax(out, std::abs(value));
  return out;
}

std::string entry_name(const tasks::RegeneratedFrf& frf) {
  const auto error = tasks::decibel_error(frf);
  const std::string alike = criteria_text(frf.measured, frf.predicted);
  return fmt::format("{} / {}{}", frf.entry.response.name(), frf.entry.reference.name(),
                     error ? fmt::format(" ({:.3g} dB{}{})", *error, alike.empty() ? "" : ", ", alike) : "");
}

/// "measured" and "regenerated", whichever there is.
std::vector<Series> overlay(Values measured, Values regenerated) {
  std::vector<Series> series;
  if (has_any(measured)) series.push_back({"measured", std::move(measured), Style::reference});
  if (has_any(regenerated)) series.push_back({"regenerated", std::move(regenerated), Style::line});
  return series;
}

/// 20 log10(|regenerated|/|measured|) at some of the lines; NaN where one of them is not there.
Values level_differences(const Values& measured, const Values& regenerated, const std::vector<std::size_t>& kept) {
  Values out;
  for (const std::size_t i : kept) out.push_back(20.0 * std::log10(regenerated[i] / measured[i]));
  return out;
}

Choice choice(const tasks::RegeneratedFrf& frf, const Values& frequency_hz, std::optional<std::array<double, 2>> used_hz,
              std::size_t most, const Display& display) {
  const std::vector<Values> curves = {magnitudes(frf.measured), magnitudes(frf.predicted)};
  const std::vector<std::size_t> kept = keep_peaks(curves, most);
  CurvePlot magnitude, phase, difference;
  magnitude.title = "Magnitude of " + frf.entry.response.name() + " / " + frf.entry.reference.name();
  magnitude.x = {"frequency (Hz)", false};
  magnitude.y = {frf_label(display, frf.entry.response, frf.entry.reference), true};
  magnitude.x_values = picked(frequency_hz, kept);
  magnitude.series = overlay(picked(curves[0], kept), picked(curves[1], kept));
  magnitude.band = used_hz;
  difference = phase = magnitude;
  phase.title = "Phase";
  phase.y = {"phase (°)", false};
  phase.series = overlay(phases_deg(frf.measured, kept), phases_deg(frf.predicted, kept));
  choose_branch(phase);
  Choice out{entry_name(frf), {magnitude, phase}};
  Values differences = level_differences(curves[0], curves[1], kept);
  if (!has_any(differences)) return out;
  difference.title = "Synthesised over measured";
  difference.y = {"dB", false};
  difference.level = 0.0;
  difference.deviation = least_deviation_db;
  difference.series = {{"difference", std::move(differences), Style::line}};
  out.plots.insert(out.plots.begin() + 1, std::move(difference));
  return out;
}

constexpr std::size_t series_of_choice = 8, most_choices = 5;

/// Of unknowns that are not zero at the end; those with the largest excursion first.
std::vector<Series> relative_unknowns(const tasks::UnknownsByIteration& found) {
  std::vector<std::pair<double, Series>> moved;
  const Values& end = found.iterations.back().values;
  for (std::size_t u = 0; u < found.names.size(); ++u) {
    if (!std::isfinite(end[u]) || end[u] == 0.0) continue;
    Series series{found.names[u], {}, Style::line};
    double most = 0.0;
    for (const tasks::IterationUnknowns& step : found.iterations) {
      series.y.push_back(step.values[u] / end[u]);
      most = std::fmax(most, std::abs(series.y.back() - 1.0));
    }
    moved.emplace_back(most, std::move(series));
  }
  std::ranges::stable_sort(moved, std::greater{}, &std::pair<double, Series>::first);
  std::vector<Series> out;
  for (auto& [most, series] : moved) out.push_back(std::move(series));
  return out;
}

}  // namespace

PlotGroup frf_overlay(const tasks::Regenerated& receptances, std::optional<std::array<double, 2>> used_hz, std::size_t most,
                      const Display& display) {
  const tasks::Regenerated regenerated = in_units_of(display, receptances);
  PlotGroup group{"FRF", {}};
  double least = 0.0;  // FRFs that vanish by symmetry are rounding errors
  for (const tasks::RegeneratedFrf& frf : regenerated.frfs) least = std::max(least, ident::zero_level * largest(frf));
  for (const tasks::RegeneratedFrf& frf : regenerated.frfs) {
    if (largest(frf) <= least) continue;
    group.choices.push_back(choice(frf, regenerated.frequency_hz, used_hz, most, display));
  }
  return group;
}

PlotGroup quality_plots(const std::vector<tasks::LineQuality>& lines) {
  PlotGroup group{"matrix", {}};
  if (lines.size() < 2) return group;
  for (const auto& last : lines.back().quality) {
    Values count, rjcf, arvf;
    for (const tasks::LineQuality& line : lines) {
      const auto found = line.quality.find(last.first);
      count.push_back(static_cast<double>(line.lines));
      rjcf.push_back(found == line.quality.end() ? missing : found->second.rjcf);
      arvf.push_back(found == line.quality.end() ? missing : found->second.arvf);
    }
    CurvePlot plot;
    plot.title = "RJCF and ARVF against the number of frequency lines";
    plot.x = {"frequency lines used", false};
    plot.y = {"RJCF, ARVF", false};
    plot.x_values = std::move(count);
    plot.series = {{"RJCF", std::move(rjcf), Style::line}, {"ARVF", std::move(arvf), Style::line}};
    plot.level = 1.0;
    group.choices.push_back({restrictions::key(last.first), {plot}});
  }
  return group;
}

PlotGroup iteration_plots(const tasks::UnknownsByIteration& found) {
  PlotGroup group{"unknowns", {}};
  if (found.iterations.size() < 2) return group;
  CurvePlot objective, unknowns;
  objective.title = "Objective";
  objective.x = unknowns.x = {"iteration", false};
  Values sums;
  for (const tasks::IterationUnknowns& step : found.iterations) {
    objective.x_values.push_back(static_cast<double>(step.iteration));
    sums.push_back(step.objective.value_or(missing));
  }
  objective.y = {"objective", std::ranges::all_of(sums, [](double sum) { return !(sum <= 0.0); })};
  const bool has_objective = has_any(sums);
  objective.series = {{"objective", std::move(sums), Style::line}};
  unknowns.title = "Unknowns over those of the solution";
  unknowns.y = {"value / value of the solution", false};
  unknowns.x_values = objective.x_values;
  unknowns.level = 1.0;
  std::vector<Series> all = relative_unknowns(found);
  for (std::size_t first = 0; first < std::min(all.size(), most_choices * series_of_choice); first += series_of_choice) {
    const std::size_t last = std::min(all.size(), first + series_of_choice);
    unknowns.series.assign(all.begin() + static_cast<std::ptrdiff_t>(first), all.begin() + static_cast<std::ptrdiff_t>(last));
    Choice one{fmt::format("{} to {} of {}", first + 1, last, all.size()), {unknowns}};
    if (has_objective) one.plots.insert(one.plots.begin(), objective);
    group.choices.push_back(std::move(one));
  }
  return group;
}

}  // namespace jointid::report
