#pragma once

#include <cmath>
#include <limits>

#include "report/page/page.hpp"

namespace jointid::report {

inline constexpr const char* nasty = "</script><script>alert('1')</script> & \"quoted\" <!--";

inline CurvePlot sample_curves() {
  CurvePlot plot{"A resonance", {"frequency (Hz)", false}, {"receptance (m/N)", true}, {}, {}, {{20.0, 60.0}}, {}, {}};
  std::vector<double> measured, phase;
  for (int i = 1; i <= 100; ++i) {
    const double f = i, re = 1.0 - f * f / 2500.0, im = 0.04 * f / 50.0;
    plot.x_values.push_back(f);
    measured.push_back(i % 10 == 0 ? std::numeric_limits<double>::quiet_NaN() : 1e-6 / std::hypot(re, im));
  }
  plot.series = {{"measured", measured, Style::reference}, {nasty, measured, Style::dashed}};
  return plot;
}

inline ScatterPlot sample_scatter() {
  ScatterPlot plot{"Error against run time", {"run time (s)", true}, {"rms error", true}, {}, {}};
  plot.groups = {{"WA", {{1e-4, 0.2, "WA, nn"}, {1e-3, 0.05, "WA, nn nj"}}},
                 {"WBS", {{1e-3, 0.03, "WBS, nn"}, {0.02, 0.01, nasty}, {0.5, 0.02, "WBS, all"}}}};
  plot.front = {{1e-4, 0.2, ""}, {1e-3, 0.03, ""}, {0.02, 0.01, ""}};
  plot.front_name = "Pareto front";
  return plot;
}

/// Points before a curve, without a front; one of the groups is empty.
inline ScatterPlot sample_poles() {
  ScatterPlot plot{"Poles",
                   {"frequency (Hz)", false},
                   {"order", false},
                   {{"poles", {{30.0, 2.0, "30 Hz"}, {50.0, 4.0, nasty}}}, {"none", {}}},
                   {}};
  plot.backdrop = {{nasty, true}, sample_curves().x_values, {{nasty, sample_curves().series[0].y, Style::reference}}};
  return plot;
}

inline StatusBanner sample_banner() {
  return {Trust::bad, nasty, nasty, {"a remark"}, {{"sign", nasty, "125:+Y", "row and column differ by 180°", "flip = [\"125:+Y\"]"}}};
}

inline HeatMap sample_heat_map() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  return {nasty, {"1:+Y", nasty}, {"1:+Y", "2:+Y", "3:+Y"}, {0.05, 0.2, 12.0, nan, 2.0, 123.4}, {7.0, 87.0}, {0.05, 1.4, 88.0}};
}

/// A strip of a deviation and a phase in a period of its own, with points.
inline std::vector<Plot> sample_strips() {
  CurvePlot strip = sample_curves(), phase = sample_curves();
  for (CurvePlot* plot : {&strip, &phase}) {
    plot->y = {"°", false};
    plot->series = {{"of", std::vector<double>(100, -120.0), Style::reference_points},
                    {"with", std::vector<double>(100, 80.0), Style::points}};
  }
  strip.level = 0.0;
  strip.deviation = 0.1;
  phase.period = 360.0;
  phase.y_range = {-270.0, 90.0};
  return {strip, phase};
}

inline HistogramPlot sample_histogram() {
  return {"K(1,1)", {"stiffness (N/m)", false}, 0.9e6, 1.1e6, {1, 4, 9, 17, 22, 15, 8, 3, 0, 1}, 1e6, "truth"};
}

/// A page with one of everything, and texts that try to break out.
inline ReportPage sample_page() {
  ReportPage page(nasty, "every kind of content");
  page.status(sample_banner());
  page.section("Tables");
  page.add(Text{nasty});
  page.add(Facts{{{"status", "ok"}, {nasty, nasty}}});
  Table table({{"method", Align::left}, {"remark", Align::left}, {"error"}});
  table.add({"one", nasty, "0.1"});
  table.add({nasty, "", "0.2"});
  page.add(table);
  page.add(table, nasty);
  page.add(table, "cut", {1, nasty});
  page.add(sample_heat_map());
  page.add(ComparedTable{{"K(1,1)", nasty},
                         {{"A1", {{"1.006", "1.01", "0.9", "1.1", InRange::inside}, {nasty, nasty, nasty, nasty, InRange::outside}}},
                          {nasty, {{"0.5", "–", "–", "–", InRange::doubtful}}}}});
  page.add(MatrixTable{"stiffness K", {"4:+Y", "5:+Y"}, {{1e6, -1e6}, {-1e6, 1e6}}, {{1.1e6, -1e6}, {-1e6, 0.0}}});
  page.add(Bars{{{"K(1,1)", 1e6, "N/m", {{0.9e6, 1.1e6}}, 1.05e6, ""},
                 {"K(1,2)", -4e5, "N/m", {}, {}, nasty},
                 {"D(1,1)", 3.0, "N/m", {{-1.0, 7.0}}, 2.0, ""}}});
  page.section("Plots");
  page.add(PlotGroup{"FRF", {{"first", {sample_curves(), sample_curves()}}, {nasty, {sample_curves()}}}});
  page.add(PlotGroup{"", {{"compared", {sample_scatter()}}}});
  page.add(PlotGroup{"", {{"trials", {sample_histogram()}}}});
  page.add(PlotGroup{"", {{"poles", {sample_poles()}}}});
  page.add(PlotGroup{"", {{"strips", sample_strips()}}});
  return page;
}

}  // namespace jointid::report
