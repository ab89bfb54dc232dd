#include <fmt/format.h>

#include "base/statistics.hpp"
#include "report/impedance/line_report.hpp"
#include "report/page/limits.hpp"
#include "report/page/page.hpp"
#include "report/page/status_banner.hpp"

namespace jointid::report {
namespace {

using impedance::IdentifiedLines;
using impedance::LineValue;
using impedance::WayResult;

/// A number of each line, NaN where there is none; every so manieth line where there are more than a screen shows.
template <class Of>
std::vector<double> over_lines(const WayResult& way, const Of& of) {
  const std::size_t step = 1 + way.lines.size() / most_points;
  std::vector<double> out;
  for (std::size_t i = 0; i < way.lines.size(); i += step) out.push_back(way.lines[i] ? of(*way.lines[i]) : nan);
  return out;
}

std::vector<double> axis_of(const IdentifiedLines& found) {
  const std::size_t step = 1 + found.frequency_hz.size() / most_points;
  std::vector<double> out;
  for (std::size_t i = 0; i < found.frequency_hz.size(); i += step) out.push_back(found.frequency_hz[i]);
  return out;
}

CurvePlot plot_over(const IdentifiedLines& found, const std::string& title, const std::string& y) {
  CurvePlot plot;
  plot.title = title;
  plot.x = {"frequency, Hz"};
  plot.y = {y};
  plot.x_values = axis_of(found);
  return plot;
}

/// The spline over the values of the first way.
template <class Part>
void add_spline(const IdentifiedLines& found, const WayResult& way, std::size_t element, CurvePlot& plot, const Part& part) {
  if (&way != &found.ways.front()) return;
  for (const impedance::SmoothElement& one : found.smooth) {
    if (one.element != element) continue;
    WayResult smooth = way;
    for (auto& line : smooth.lines) line.reset();
    for (std::size_t q = 0; q < one.lines.size(); ++q) {
      LineValue value;
      value.z = Eigen::VectorXcd::Zero(static_cast<Eigen::Index>(way.elements.size()));
      value.z(static_cast<Eigen::Index>(element)) = one.fit.z(static_cast<Eigen::Index>(q));
      smooth.lines[one.lines[q]] = std::move(value);
    }
    plot.series.push_back({"spline", over_lines(smooth, part), Style::line});
  }
}

/// The best law over the values of the first way.
template <class Part>
void add_law(const IdentifiedLines& found, const WayResult& way, CurvePlot& plot, const Part& part) {
  if (found.laws.empty() || !found.laws.front().converged || &way != &found.ways.front()) return;
  WayResult law = way;
  law.lines = found.laws.front().lines;
  plot.series.push_back({"law " + impedance::name(found.laws.front().law), over_lines(law, part), Style::reference});
}

CurvePlot part_plot(const IdentifiedLines& found, const WayResult& way, std::size_t element, bool imaginary) {
  const auto t = static_cast<Eigen::Index>(element);
  const auto part = [=](const LineValue& line) { return imaginary ? line.z(t).imag() : line.z(t).real(); };
  const auto error = [=](const LineValue& line) { return normal_95 * (imaginary ? line.im_error(t) : line.re_error(t)); };
  CurvePlot plot = plot_over(found, (imaginary ? "Im " : "Re ") + way.elements[element].name, way.elements[element].unit);
  plot.series.push_back({"value", over_lines(way, part), Style::line});
  add_law(found, way, plot, part);
  add_spline(found, way, element, plot, part);
  plot.series.push_back(
      {"95 % low", over_lines(way, [=](const LineValue& line) { return part(line) - error(line); }), Style::dashed});
  plot.series.push_back(
      {"95 % high", over_lines(way, [=](const LineValue& line) { return part(line) + error(line); }), Style::dashed});
  return plot;
}

}  // namespace

PlotGroup line_element_plots(const IdentifiedLines& found, const WayResult& way) {
  PlotGroup out{.menu = "element", .choices = {}};
  for (std::size_t e = 0; e < std::min(most_frfs, way.elements.size()); ++e) {
    const auto t = static_cast<Eigen::Index>(e);
    CurvePlot loss = plot_over(found, "loss factor", "Im/Re");
    loss.series.push_back(
        {"loss factor", over_lines(way, [t](const LineValue& line) { return line.z(t).imag() / line.z(t).real(); })});
    out.choices.push_back(
        {way.elements[e].name, {part_plot(found, way, e, false), part_plot(found, way, e, true), std::move(loss)}});
  }
  return out;
}

PlotGroup line_misfit_plot(const IdentifiedLines& found) {
  CurvePlot plot = plot_over(found, "χ² over degrees of freedom", "χ²/f");
  plot.level = 1.0;
  const auto ratio = [](const LineValue& line) { return line.freedom > 0.0 ? line.chi_square / line.freedom : nan; };
  plot.series.push_back({"likelihood", over_lines(found.likelihood, ratio)});
  return {.menu = "", .choices = {{"", {std::move(plot)}}}};
}

std::string line_page(const impedance::LineScene& scene, const IdentifiedLines& found) {
  ReportPage page(scene.scene.title.empty() ? "Dynamic stiffness of the joint" : scene.scene.title, "jointid solve");
  page.status(status_banner(name(found.status), found.message));
  page.section("Summary");
  page.add(Facts{{{"lines", fmt::format("{}", found.frequency_hz.size())},
                  {"structure", impedance::name(scene.structure)},
                  {"χ² of degrees of freedom", fmt::format("{:.5g} of {:.0f}", found.chi_square, found.freedom)}}});
  for (const std::string& note : found.notes) page.add(Text{note, true});
  for (const WayResult& way : found.ways) {
    page.section("Z by way " + impedance::name(way.way));
    page.add(line_element_plots(found, way));
  }
  if (!found.laws.empty()) {
    page.section("Laws");
    page.add(law_table(found));
  }
  if (found.freedom > 0.0) {
    page.section("Misfit");
    page.add(line_misfit_plot(found));
  }
  page.add(Text{"Bands are 95 % intervals of single lines; each covers on its own.", true});
  return page.html();
}

}  // namespace jointid::report
