#include "gui/plot/curve_drawing.hpp"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/text.hpp"
#include "gui/plot/panel_drawing.hpp"
#include "gui/plot/quoted.hpp"

namespace jointid::gui {
namespace {

constexpr double strip_share = 0.4;  ///< of the height of other diagrams, of residuals

QVector<QCPGraphData> data_of(const std::vector<double>& x, const std::vector<double>& y) {
  QVector<QCPGraphData> data;
  data.reserve(static_cast<qsizetype>(y.size()));
  for (std::size_t i = 0; i < y.size(); ++i) data.push_back(QCPGraphData(x[i], y[i]));
  return data;
}

bool are_points(report::Style style) { return style == report::Style::points || style == report::Style::reference_points; }

bool is_reference(report::Style style) { return style == report::Style::reference || style == report::Style::reference_points; }

void set_style(QCPGraph& graph, report::Style style, const QColor& colour) {
  if (are_points(style)) {
    graph.setLineStyle(QCPGraph::lsNone);
    graph.setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, colour, colour, 4));
    graph.setPen(QPen(colour));
    return;
  }
  const bool broad = style == report::Style::reference;
  graph.setPen(QPen(colour, broad ? 3.0 : 1.0, style == report::Style::dashed ? Qt::DashLine : Qt::SolidLine));
}

/// A curve is broken where it jumps by more than half the period.
std::vector<double> broken(std::vector<double> y, const std::optional<double>& period) {
  for (std::size_t i = y.size(); period && i > 1; --i) {
    if (std::abs(y[i - 1] - y[i - 2]) > 0.5 * *period) y[i - 1] = std::nan("");
  }
  return y;
}

void draw_level(QCustomPlot& plot, QCPAxisRect& rect, double level, Theme theme) {
  auto* line = new QCPItemStraightLine(&plot);
  line->setClipAxisRect(&rect);
  line->setPen(QPen(colours(theme).weak_text, 1, Qt::DashLine));
  for (QCPItemPosition* end : {line->point1, line->point2}) {
    end->setAxisRect(&rect);
    end->setAxes(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft));
    end->setTypeX(QCPItemPosition::ptAxisRectRatio);
    end->setTypeY(QCPItemPosition::ptPlotCoords);
  }
  line->point1->setCoords(0.0, level);
  line->point2->setCoords(1.0, level);
}

/// The y-axis round the curves, round the level as much above as below, or as the plot says.
void fit_ordinates(QCPAxis& y, const report::CurvePlot& shown) {
  if (shown.y_range) return y.setRange((*shown.y_range)[0], (*shown.y_range)[1]);
  if (shown.deviation) {
    const double level = shown.level.value_or(0.0);
    const double most = std::max({*shown.deviation, std::abs(y.range().upper - level), std::abs(y.range().lower - level)});
    return y.setRange(level - 1.05 * most, level + 1.05 * most);
  }
  y.scaleRange(y.scaleType() == QCPAxis::stLogarithmic ? 1.02 : 1.08);
}

std::vector<double> ordinates_of(const report::CurvePlot& shown) {
  std::vector<double> out;
  for (const report::Series& series : shown.series) out.insert(out.end(), series.y.begin(), series.y.end());
  return out;
}

/// Colours of curves with the same name are the same in all diagrams.
class Names {
 public:
  int place_of(const std::string& name) {
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (names_[i] == name) return static_cast<int>(i);
    }
    names_.push_back(name);
    return static_cast<int>(names_.size()) - 1;
  }
  /// Whether this is the first time that it is asked.
  bool to_legend(const std::string& name) { return in_legend_.insert(name).second; }

 private:
  std::vector<std::string> names_;
  std::set<std::string> in_legend_;
};

QCPAxisRect* draw_one(QCustomPlot& plot, const report::CurvePlot& shown, Names& names, Theme theme) {
  auto* rect = new QCPAxisRect(&plot);
  plot.plotLayout()->addElement(plot.plotLayout()->rowCount(), 0, rect);
  style_axes(*rect, theme);
  QCPAxis* const x = rect->axis(QCPAxis::atBottom);
  QCPAxis* const y = rect->axis(QCPAxis::atLeft);
  set_axis(*x, shown.x);
  set_axis(*y, shown.y);
  bool found = false;
  for (const report::Series& series : shown.series) {
    QCPGraph* const graph = plot.addGraph(x, y);
    graph->setName(QString::fromStdString(series.name));
    const QColor colour =
        is_reference(series.style) ? colours(theme).weak_text : curve_colour(theme, names.place_of(series.name));
    set_style(*graph, series.style, colour);
    graph->data()->set(data_of(shown.x_values, broken(series.y, shown.period)), true);
    if (!series.name.empty() && names.to_legend(series.name)) graph->addToLegend(plot.legend);
    graph->rescaleAxes(found);
    found = true;
  }
  for (QCPAxis* axis : {x, y}) give_room(*axis, axis == x ? shown.x_values : ordinates_of(shown));
  fit_ordinates(*y, shown);
  if (shown.level) draw_level(plot, *rect, *shown.level, theme);
  return rect;
}

void share_range(QCPAxis& one, QCPAxis& other) {
  QObject::connect(&one, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), &other,
                   qOverload<const QCPRange&>(&QCPAxis::setRange));
  QObject::connect(&other, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), &one,
                   qOverload<const QCPRange&>(&QCPAxis::setRange));
}

/// One axis with numbers below those that share it, and as many numbers at the left as there is room for.
void leave_room(const QCustomPlot& plot, const std::vector<QCPAxisRect*>& rects) {
  constexpr int of_a_number = 24, above_and_below = 30, most = 5;  // pixels; numbers
  for (std::size_t i = 0; i < rects.size(); ++i) {
    QCPAxis* const x = rects[i]->axis(QCPAxis::atBottom);
    QCPAxis* const y = rects[i]->axis(QCPAxis::atLeft);
    const int height = plot.height() / static_cast<int>(rects.size()) - above_and_below;
    if (y->scaleType() == QCPAxis::stLinear) y->ticker()->setTickCount(std::clamp(height / of_a_number, 1, most));
    if (i + 1 == rects.size() || rects[i + 1]->axis(QCPAxis::atBottom)->label() != x->label()) continue;
    x->setLabel(QString());
    x->setTickLabels(false);
  }
}

}  // namespace

void set_axis(QCPAxis& axis, const report::Axis& wanted) {
  axis.setLabel(axis_text(wanted.label));
  if (!wanted.log) return;
  axis.setScaleType(QCPAxis::stLogarithmic);
  axis.setTicker(QSharedPointer<QCPAxisTickerLog>::create());
  axis.setNumberFormat(QStringLiteral("gb"));
}

void draw_curves(QCustomPlot& plot, const std::vector<report::CurvePlot>& plots, Theme theme) {
  plot.setPlottingHint(QCP::phFastPolylines);  // broad lines take many times as long without
  add_legend(plot, theme);
  auto* margins = new QCPMarginGroup(&plot);
  Names names;
  std::vector<QCPAxisRect*> rects;
  for (const report::CurvePlot& shown : plots) {
    QCPAxisRect* const rect = draw_one(plot, shown, names, theme);
    rect->setMarginGroup(QCP::msLeft | QCP::msRight, margins);
    if (shown.deviation) plot.plotLayout()->setRowStretchFactor(plot.plotLayout()->rowCount() - 1, strip_share);
    for (std::size_t i = 0; i < rects.size(); ++i) {
      if (plots[i].x.label != shown.x.label || plots[i].x.log != shown.x.log) continue;
      rect->axis(QCPAxis::atBottom)->setRange(rects[i]->axis(QCPAxis::atBottom)->range());
      share_range(*rects[i]->axis(QCPAxis::atBottom), *rect->axis(QCPAxis::atBottom));
      break;
    }
    rects.push_back(rect);
  }
  leave_room(plot, rects);
}

void draw_backdrop(QCustomPlot& plot, QCPAxisRect& rect, const report::Backdrop& backdrop, Theme theme) {
  QCPAxis* const x = rect.axis(QCPAxis::atBottom);
  QCPAxis* const y = rect.axis(QCPAxis::atRight);
  y->setVisible(true);
  set_axis(*y, backdrop.y);
  y->grid()->setVisible(false);
  bool found = false;
  for (const report::Series& series : backdrop.series) {
    QCPGraph* const graph = plot.addGraph(x, y);
    graph->setLayer(QStringLiteral("grid"));
    graph->setName(QString::fromStdString(series.name));
    QColor colour = colours(theme).weak_text;
    colour.setAlpha(found ? 110 : 200);
    graph->setPen(QPen(colour, 1));
    graph->data()->set(data_of(backdrop.x_values, series.y), true);
    graph->addToLegend(plot.legend);
    graph->rescaleValueAxis(found);
    found = true;
  }
  if (!backdrop.x_values.empty()) x->setRange(backdrop.x_values.front(), backdrop.x_values.back());
}

std::string curve_table(const std::vector<report::CurvePlot>& plots, char separator) {
  std::string text;
  for (const report::CurvePlot& plot : plots) {
    text += (text.empty() ? "" : "\n") + quoted(plot.x.label);
    for (const report::Series& series : plot.series)
      text += separator + quoted(series.name + (series.name.empty() ? "" : ", ") + plot.y.label);
    text += "\n";
    for (std::size_t i = 0; i < plot.x_values.size(); ++i) {
      text += digits(plot.x_values[i], "%.17g");
      for (const report::Series& series : plot.series)
        text += separator + (std::isnan(series.y[i]) ? std::string() : digits(series.y[i], "%.17g"));
      text += "\n";
    }
  }
  return text;
}

}  // namespace jointid::gui
