#include "report/couple/couple_plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/statistics.hpp"
#include "report/decimate.hpp"
#include "report/frf_curves.hpp"
#include "report/page/phase_branch.hpp"
#include "report/text/display_of_tasks.hpp"

namespace jointid::report {
namespace {

using Values = std::vector<double>;
using coupling::LineRecord;

constexpr std::size_t most_together = 12;

CurvePlot over_frequency(const std::string& title, Axis y, const Values& frequency_hz, std::vector<Series> series, std::size_t most) {
  std::vector<Values> curves;
  for (const Series& one : series) curves.push_back(one.y);
  const std::vector<std::size_t> kept = keep_peaks(curves, most);
  for (Series& one : series) one.y = picked(one.y, kept);
  return {title, {"frequency (Hz)", false}, std::move(y), picked(frequency_hz, kept), std::move(series), {}, {}, {}};
}

double positive(double value) { return value > 0.0 ? value : nan; }

/// One value per line, those that are not positive left out.
template <class Of>
Values per_line(const std::vector<LineRecord>& lines, Of of) {
  Values out;
  for (const LineRecord& line : lines) out.push_back(positive(of(line)));
  return out;
}

/// s/|H| of an FRF with variances.
double relative_deviation(std::complex<double> h, std::complex<double> variance) {
  const double square = std::norm(h);
  return std::sqrt(h.real() * h.real() * variance.real() + h.imag() * h.imag() * variance.imag()) / square;
}

/// The broad curve is what was measured, where that is there.
Style bound_style(const tasks::PredictedFrf& frf) { return frf.measured.empty() ? Style::reference : Style::line; }

std::vector<Series> magnitude_series(const tasks::PredictedFrf& frf) {
  std::vector<Series> series;
  if (!frf.measured.empty()) series.push_back({"measured", magnitudes(frf.measured), Style::reference});
  if (!frf.with_all.empty()) series.push_back({"with all conditions", magnitudes(frf.with_all), bound_style(frf)});
  series.push_back({"predicted", magnitudes(frf.value), Style::line});
  if (frf.variance.empty()) return series;
  Series upper{"95 %, upper", series.back().y, Style::dashed}, lower{"95 %, lower", series.back().y, Style::dashed};
  for (std::size_t i = 0; i < frf.value.size(); ++i) {
    const double factor = std::exp(normal_95 * relative_deviation(frf.value[i], frf.variance[i]));
    upper.y[i] *= factor;
    lower.y[i] /= factor;
  }
  series.push_back(std::move(upper));
  series.push_back(std::move(lower));
  return series;
}

Values all_phases(const std::vector<std::complex<double>>& frf) {
  std::vector<std::size_t> every(frf.size());
  for (std::size_t i = 0; i < every.size(); ++i) every[i] = i;
  return phases_deg(frf, every);
}

Choice choice(const Values& frequency_hz, const tasks::PredictedFrf& frf, std::size_t most, const Display& display) {
  const std::string name = frf.response.name() + " / " + frf.reference.name();
  std::vector<Series> phases;
  if (!frf.measured.empty()) phases.push_back({"measured", all_phases(frf.measured), Style::reference});
  if (!frf.with_all.empty()) phases.push_back({"with all conditions", all_phases(frf.with_all), bound_style(frf)});
  phases.push_back({"predicted", all_phases(frf.value), Style::line});
  CurvePlot phase = over_frequency("Phase", {"phase (°)", false}, frequency_hz, std::move(phases), most);
  choose_branch(phase);
  return {name,
          {over_frequency("Magnitude of " + name, {frf_label(display, frf.response, frf.reference), true}, frequency_hz,
                          magnitude_series(frf), most),
           phase}};
}

/// The singular values, the first twelve of them, and what the first that was dropped had to exceed, or the last when none was.
std::vector<Series> singular_value_series(const std::vector<LineRecord>& lines) {
  std::vector<Series> series;
  const std::size_t count = lines.front().sigma.size();
  for (std::size_t i = 0; i < std::min(count, most_together); ++i) {
    series.push_back({fmt::format("{}", i + 1), per_line(lines, [i](const LineRecord& line) { return line.sigma[i]; }), Style::line});
  }
  series.push_back({"threshold",
                    per_line(lines, [count](const LineRecord& line) { return line.limit[std::min(line.kept, count - 1)]; }),
                    Style::dashed});
  return series;
}

}  // namespace

PlotGroup predicted_plots(const std::vector<double>& frequency_hz, const std::vector<tasks::PredictedFrf>& frfs, std::size_t most,
                          const Display& display) {
  PlotGroup group{"FRF", {}};
  for (const tasks::PredictedFrf& frf : in_units_of(display, frequency_hz, frfs))
    group.choices.push_back(choice(frequency_hz, frf, most, display));
  return group;
}

PlotGroup condition_plots(const tasks::CoupleResult& result, std::size_t most) {
  const std::vector<LineRecord>& lines = result.records;
  Choice choice{"", {}};
  const auto add = [&](const std::string& title, Axis y, std::vector<Series> series) {
    choice.plots.emplace_back(over_frequency(title, std::move(y), result.frequency_hz, std::move(series), most));
  };
  add("Condition of S", {"condition number", true},
      {{"condition", per_line(lines, [](const LineRecord& line) { return line.condition; }), Style::line}});
  if (!lines.front().sigma.empty()) add("Singular values of S", {"singular value", true}, singular_value_series(lines));
  const bool drops =
      std::ranges::any_of(lines, [&](const LineRecord& line) { return line.usable && line.kept != result.result.conditions; });
  if (drops) {
    Values kept;
    for (const LineRecord& line : lines) kept.push_back(line.usable ? static_cast<double>(line.kept) : nan);
    add("Kept", {fmt::format("of {}", result.result.conditions), false}, {{"kept", std::move(kept), Style::line}});
  }
  return {"", {choice}};
}

PlotGroup alpha_plots(const std::vector<double>& frequency_hz, const std::vector<LineRecord>& lines,
                      const std::vector<std::string>& conditions, std::optional<double> level, std::size_t most) {
  PlotGroup group{"conditions", {}};
  if (lines.empty() || lines.front().alpha.empty()) return group;
  for (std::size_t first = 0; first < conditions.size(); first += most_together) {
    const std::size_t end = std::min(first + most_together, conditions.size());
    std::vector<Series> series;
    for (std::size_t p = first; p < end; ++p) {
      series.push_back({conditions[p], per_line(lines, [p](const LineRecord& line) { return line.alpha[p]; }), Style::line});
    }
    CurvePlot plot = over_frequency("Alpha of each condition", {"alpha", true}, frequency_hz, std::move(series), most);
    plot.level = level;
    group.choices.push_back({conditions[first] + (end > first + 1 ? " … " + conditions[end - 1] : ""), {plot}});
  }
  return group;
}

}  // namespace jointid::report
