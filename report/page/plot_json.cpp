#include "report/page/plot_json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

namespace jointid::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr int y_digits = 6, x_digits = 9;

/// Rounded, so that it is written with few digits.
Json rounded(double value, int digits) {
  if (!std::isfinite(value)) return nullptr;
  return std::strtod(fmt::format("{:.{}g}", value, digits).c_str(), nullptr);
}

Json array(const std::vector<double>& values, int digits) {
  Json out = Json::array();
  for (const double value : values) out.push_back(rounded(value, digits));
  return out;
}

Json axis(const Axis& axis) { return {{"label", axis.label}, {"log", axis.log}}; }

const char* name(Style style) {
  switch (style) {
    case Style::line: return "line";
    case Style::reference: return "reference";
    case Style::dashed: return "dashed";
    case Style::reference_points: return "reference points";
    case Style::points: break;
  }
  return "points";
}

Json points(const std::vector<Point>& list) {
  Json out = Json::array();
  for (const Point& point : list) {
    out.push_back({rounded(point.x, y_digits), rounded(point.y, y_digits), point.label});
  }
  return out;
}

Json series_json(const std::vector<Series>& list) {
  Json out = Json::array();
  for (const Series& series : list) {
    out.push_back({{"name", series.name}, {"style", name(series.style)}, {"y", array(series.y, y_digits)}});
  }
  return out;
}

Json json(const CurvePlot& plot) {
  Json out = {{"kind", "curves"}, {"title", plot.title}, {"x", axis(plot.x)}, {"y", axis(plot.y)}};
  out["values"] = array(plot.x_values, x_digits);
  out["series"] = series_json(plot.series);
  if (plot.band) out["band"] = {rounded((*plot.band)[0], x_digits), rounded((*plot.band)[1], x_digits)};
  if (plot.level) out["level"] = rounded(*plot.level, y_digits);
  if (plot.period) out["period"] = rounded(*plot.period, y_digits);
  if (plot.y_range) out["yRange"] = {rounded((*plot.y_range)[0], y_digits), rounded((*plot.y_range)[1], y_digits)};
  if (plot.deviation) out["deviation"] = rounded(*plot.deviation, y_digits);
  return out;
}

Json json(const ScatterPlot& plot) {
  Json out = {{"kind", "scatter"}, {"title", plot.title}, {"x", axis(plot.x)}, {"y", axis(plot.y)}};
  out["groups"] = Json::array();
  for (const PointGroup& group : plot.groups) {
    out["groups"].push_back({{"name", group.name}, {"points", points(group.points)}});
  }
  out["front"] = points(plot.front);
  out["frontName"] = plot.front_name;
  if (plot.backdrop) {
    out["backdrop"] = {{"y", axis(plot.backdrop->y)},
                       {"values", array(plot.backdrop->x_values, x_digits)},
                       {"series", series_json(plot.backdrop->series)}};
  }
  return out;
}

Json json(const HistogramPlot& plot) {
  Json out = {{"kind", "histogram"}, {"title", plot.title}, {"x", axis(plot.x)}};
  out["range"] = {rounded(plot.low, x_digits), rounded(plot.high, x_digits)};
  out["counts"] = array(plot.counts, y_digits);
  if (plot.mark) out["mark"] = {{"x", rounded(*plot.mark, x_digits)}, {"name", plot.mark_name}};
  return out;
}

/// Curves over the same points as the plot before say so instead of repeating them.
Json plots(const std::vector<Plot>& list) {
  Json out = Json::array();
  const CurvePlot* before = nullptr;
  for (const Plot& plot : list) {
    Json& written = out.emplace_back(std::visit([](const auto& one) { return json(one); }, plot));
    const auto* curves = std::get_if<CurvePlot>(&plot);
    if (curves != nullptr && before != nullptr && curves->x_values == before->x_values) written["values"] = "same";
    before = curves;
  }
  return out;
}

}  // namespace

std::string plot_json(const PlotGroup& group) {
  Json choices = Json::array();
  for (const Choice& choice : group.choices) {
    choices.push_back({{"name", choice.name}, {"plots", plots(choice.plots)}});
  }
  const Json out = {{"menu", group.menu}, {"choices", choices}};
  return out.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace jointid::report
