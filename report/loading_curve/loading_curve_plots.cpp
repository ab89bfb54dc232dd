#include "report/loading_curve/loading_curve_plots.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "report/decimate.hpp"

namespace jointid::report {
namespace {

using friction::Curve;
using friction::CurveFit;
using friction::CurveKind;
using friction::Fit;
using Values = std::vector<double>;

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t most_samples = 1500;

/// Fits that have something to draw.
std::vector<const Fit*> drawn(const tasks::LoadingCurveResult& result) {
  std::vector<const Fit*> out;
  for (const Fit& fit : result.fits) {
    if (!fit.curves.empty()) out.push_back(&fit);
  }
  return out;
}

/// Rows [first, last) of a curve in the order of their displacements.
std::vector<std::size_t> ascending(const Curve& curve, std::size_t first, std::size_t last) {
  std::vector<std::size_t> order(last - first);
  std::iota(order.begin(), order.end(), first);
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return curve.u[i]; });
  return order;
}

/// What is drawn of a curve: some rows in the order of their displacements, and a word for the axis ("rising") that keeps
/// branches with axes of their own apart.
struct Part {
  std::string title, axis, quantity;
  std::vector<std::size_t> rows;
  std::size_t offset = 0;
};

/// One quantity over one axis: measured and by every law, and below it the residuals.
std::vector<Plot> overlay(const tasks::LoadingCurveResult& result, std::size_t number, const Part& part) {
  const auto& [title, axis, quantity, rows, offset] = part;
  const Curve& curve = result.data.curves[number];
  CurvePlot value, residual;
  value.title = title;
  value.x = {axis + " (" + curve.displacement_unit + ")", false};
  value.y = {quantity, false};
  Values measured;
  double largest = 0.0;
  for (const std::size_t row : rows) {
    value.x_values.push_back(curve.u[row]);
    measured.push_back(curve.measured(row + offset));
    largest = std::max(largest, std::abs(measured.back()));
  }
  residual.title = "Residuals";
  residual.x = value.x;
  residual.y = {"(fit − measured) / largest", false};
  residual.level = 0.0;
  std::vector<Values> all = {measured};
  for (const Fit* fit : drawn(result)) {
    Values fitted;
    for (const std::size_t row : rows) fitted.push_back(fit->curves[number].predicted[row + offset]);
    all.push_back(std::move(fitted));
  }
  const std::vector<std::size_t> kept = keep_peaks(all, most_samples);
  value.x_values = picked(value.x_values, kept);
  residual.x_values = value.x_values;
  value.series.push_back({"measured", picked(all[0], kept), Style::reference});
  for (std::size_t i = 1; i < all.size(); ++i) {
    const std::string law = drawn(result)[i - 1]->law;
    Values difference = picked(all[i], kept);
    value.series.push_back({law, difference, Style::line});
    const Values& from = value.series[0].y;
    for (std::size_t k = 0; k < difference.size(); ++k) difference[k] = (difference[k] - from[k]) / largest;
    residual.series.push_back({law, std::move(difference), Style::line});
  }
  if (residual.series.empty()) return {value};
  return {value, residual};
}

void append(std::vector<Plot>& to, std::vector<Plot> more) {
  for (Plot& plot : more) to.push_back(std::move(plot));
}

std::vector<Plot> plots_of(const tasks::LoadingCurveResult& result, std::size_t number) {
  const Curve& curve = result.data.curves[number];
  const std::size_t size = curve.u.size();
  const std::string force = "force (" + curve.force_unit + ")", stiffness = curve.force_unit + "/" + curve.displacement_unit;
  if (curve.kind == CurveKind::loading)
    return overlay(result, number, {"Loading curve", "displacement", force, ascending(curve, 0, size), 0});
  if (curve.kind == CurveKind::energy)
    return overlay(result, number, {"Energy per cycle", "amplitude", "energy (J)", ascending(curve, 0, size), 0});
  std::vector<Plot> out;
  if (curve.kind == CurveKind::loop) {
    append(out,
           overlay(result, number, {"Rising branch", "displacement, rising", force, ascending(curve, 0, curve.turn + 1), 0}));
    append(out, overlay(result, number,
                        {"Falling branch", "displacement, falling", force, ascending(curve, curve.turn + 1, size), 0}));
  } else {
    append(out, overlay(result, number,
                        {"Equivalent stiffness", "amplitude", "k_e (" + stiffness + ")", ascending(curve, 0, size), 0}));
    append(out, overlay(result, number,
                        {"Equivalent damping", "amplitude", "d_e (" + stiffness + ")", ascending(curve, 0, size), size}));
  }
  return out;
}

/// `count` numbers from 0 to `size` − 1, evenly.
std::vector<std::size_t> evenly(std::size_t size, std::size_t most) {
  std::vector<std::size_t> out;
  const std::size_t count = std::min(size, most);
  for (std::size_t i = 0; i < count; ++i) out.push_back(count == 1 ? 0 : i * (size - 1) / (count - 1));
  return out;
}

/// Smallest displacement with a slipped share of at least h, NaN beyond `most`.
double slip_displacement(const friction::Element& element, double h, double most) {
  const double first = element.response(0.0).tangent;
  const auto slips = [&](double u) { return 1.0 - element.response(u).tangent / first >= h; };
  if (!slips(most)) return no_value;
  double low = 0.0, high = most;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (slips(middle) ? high : low) = middle;
  }
  return high;
}

/// What is drawn over amplitude.
using Quantity = double (*)(const friction::Equivalent&);

CurvePlot over_amplitude(const tasks::LoadingCurveResult& result, std::size_t number, const std::string& title,
                         const std::string& unit, Quantity quantity) {
  CurvePlot plot;
  plot.title = title;
  plot.y = {unit, false};
  for (const Fit* fit : drawn(result)) {
    const CurveFit& curve = *tasks::different(result, *fit)[number];
    plot.x = {"amplitude (" + curve.curve.displacement_unit + ")", true};
    Values y;
    plot.x_values.clear();
    for (const friction::Equivalent& row : tasks::equivalents(curve, 80)) {
      plot.x_values.push_back(row.amplitude);
      y.push_back(quantity(row));
    }
    plot.series.push_back({fit->law, std::move(y), Style::line});
  }
  return plot;
}

}  // namespace

PlotGroup curves_and_residuals(const tasks::LoadingCurveResult& result, std::size_t most) {
  PlotGroup group{"curve", {}};
  for (const std::size_t number : evenly(result.data.curves.size(), most)) {
    group.choices.push_back({result.data.curves[number].name, plots_of(result, number)});
  }
  return group;
}

PlotGroup slip_distribution(const tasks::LoadingCurveResult& result) {
  PlotGroup group{"curve", {}};
  if (drawn(result).empty()) return group;
  const std::size_t elements = tasks::different(result, *drawn(result).front()).size();
  for (std::size_t number = 0; number < elements; ++number) {
    CurvePlot plot;
    plot.title = "Where the stiffness area slips";
    plot.x = {"slipped share h of the stiffness area", false};
    for (int i = 1; i <= 100; ++i) plot.x_values.push_back(i / 100.0);
    for (const Fit* fit : drawn(result)) {
      const CurveFit& curve = *tasks::different(result, *fit)[number];
      plot.y = {"displacement u(h) (" + curve.curve.displacement_unit + ")", true};
      Values u;
      for (const double h : plot.x_values)
        u.push_back(slip_displacement(*curve.element, h, 5.0 * curve.curve.largest_displacement()));
      if (std::ranges::any_of(u, [](double each) { return std::isfinite(each); }))
        plot.series.push_back({fit->law, std::move(u), Style::line});
    }
    plot.level = result.data.curves[number].largest_displacement();
    group.choices.push_back({result.data.loops ? "all loops" : result.data.curves[number].name, {plot}});
  }
  return group;
}

PlotGroup equivalents_plots(const tasks::LoadingCurveResult& result) {
  PlotGroup group{"curve", {}};
  if (drawn(result).empty()) return group;
  const std::size_t elements = tasks::different(result, *drawn(result).front()).size();
  for (std::size_t number = 0; number < elements; ++number) {
    const Curve& curve = result.data.curves[number];
    const std::string unit = " (" + curve.force_unit + "/" + curve.displacement_unit + ")";
    group.choices.push_back({result.data.loops ? "all loops" : curve.name,
                             {over_amplitude(result, number, "Equivalent stiffness", "k_e" + unit,
                                             [](const friction::Equivalent& row) { return row.stiffness; }),
                              over_amplitude(result, number, "Equivalent damping", "d_e" + unit,
                                             [](const friction::Equivalent& row) { return row.damping; }),
                              over_amplitude(result, number, "Energy per cycle", "energy (J)",
                                             [](const friction::Equivalent& row) { return row.energy; })}});
  }
  return group;
}

PlotGroup loops_in_turn(const tasks::LoadingCurveResult& result) {
  PlotGroup group{"", {}};
  if (result.of_loops.empty()) return group;
  const auto in_turn = [&](const std::string& title, const std::string& unit,
                           const std::function<double(const CurveFit&)>& figure) {
    CurvePlot plot;
    plot.title = title;
    plot.x = {"loop", false};
    plot.y = {unit, false};
    for (std::size_t i = 0; i < result.data.curves.size(); ++i) plot.x_values.push_back(static_cast<double>(i + 1));
    for (std::size_t law = 0; law < result.of_loops.size(); ++law) {
      Values y;
      for (const Fit& fit : result.of_loops[law]) y.push_back(fit.curves.empty() ? no_value : figure(fit.curves[0]));
      if (std::ranges::any_of(y, [](double each) { return std::isfinite(each); }))
        plot.series.push_back({result.fits[law].law, std::move(y), Style::line});
    }
    return plot;
  };
  const Curve& curve = result.data.curves.front();
  const auto limit = [](const CurveFit& fit) { return fit.limit.value; };
  const auto stiffness = [](const CurveFit& fit) { return fit.stiffness.value; };
  const auto energy = [](const CurveFit& fit) { return 100.0 * tasks::energy_error(fit); };
  group.choices.push_back(
      {"",
       {in_turn("Friction limit", "limit (" + curve.force_unit + ")", limit),
        in_turn("Initial stiffness", "stiffness (" + curve.force_unit + "/" + curve.displacement_unit + ")", stiffness),
        in_turn("Energy of the fitted loop against the measured one", "error (%)", energy)}});
  return group;
}

}  // namespace jointid::report
