#include "gui/plot/chart_drawing.hpp"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "gui/plot/curve_drawing.hpp"
#include "gui/plot/panel_drawing.hpp"
#include "gui/plot/quoted.hpp"

namespace jointid::gui {
namespace {

constexpr int in_a_row = 4, narrowest = 180, below_axis = 45, of_a_number = 18;  // pixels
constexpr std::size_t few_points = 60;  ///< of a group, which are drawn large
constexpr const char* ring_name = "ring";

QCPGraph* add_points(QCustomPlot& plot, QCPAxisRect& rect, const std::vector<report::Point>& points) {
  QCPGraph* const graph = plot.addGraph(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft));
  for (const report::Point& point : points) graph->addData(point.x, point.y);
  return graph;
}

/// As much more room as points and their rings need.
void widen(QCPAxis& axis) {
  constexpr double share = 0.06;
  const QCPRange range = axis.range();
  if (axis.scaleType() == QCPAxis::stLogarithmic) {
    const double factor = std::pow(range.upper / range.lower, share);
    axis.setRange(range.lower / factor, range.upper * factor);
  } else {
    axis.setRange(range.lower - share * range.size(), range.upper + share * range.size());
  }
}

void draw_mark(QCustomPlot& plot, QCPAxisRect& rect, double at, const QString& name, Theme theme) {
  auto* line = new QCPItemStraightLine(&plot);
  line->setClipAxisRect(&rect);
  line->setPen(QPen(colours(theme).error, 1.5, Qt::DashLine));
  for (QCPItemPosition* end : {line->point1, line->point2}) {
    end->setAxes(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft));
    end->setAxisRect(&rect);
    end->setTypeX(QCPItemPosition::ptPlotCoords);
    end->setTypeY(QCPItemPosition::ptAxisRectRatio);
  }
  line->point1->setCoords(at, 0.0);
  line->point2->setCoords(at, 1.0);
  auto* text = new QCPItemText(&plot);
  text->setClipAxisRect(&rect);
  text->setText(" " + name);
  text->setColor(colours(theme).error);
  text->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
  text->position->setAxes(rect.axis(QCPAxis::atBottom), rect.axis(QCPAxis::atLeft));
  text->position->setAxisRect(&rect);
  text->position->setTypeX(QCPItemPosition::ptPlotCoords);
  text->position->setTypeY(QCPItemPosition::ptAxisRectRatio);
  text->position->setCoords(at, 0.0);
}

/// `room`: pixels for all of it; numbers are as many as do not touch each other.
void draw_histogram(QCustomPlot& plot, QCPAxisRect& rect, const report::HistogramPlot& histogram, QSize room, Theme theme) {
  style_axes(rect, theme);
  QCPAxis* const x = rect.axis(QCPAxis::atBottom);
  QCPAxis* const y = rect.axis(QCPAxis::atLeft);
  const QString unit = QString::fromStdString(histogram.x.label);
  const QString label = QString::fromStdString(histogram.title) + (unit.isEmpty() ? QString() : " (" + unit + ")");
  x->setLabel(QFontMetrics(x->labelFont()).elidedText(label, Qt::ElideRight, room.width() - 20));
  x->ticker()->setTickCount(2);
  x->setNumberPrecision(4);
  y->ticker()->setTickStepStrategy(QCPAxisTicker::tssMeetTickCount);
  y->ticker()->setTickCount(std::clamp((room.height() - below_axis) / of_a_number, 1, 3));
  const double width = (histogram.high - histogram.low) / static_cast<double>(std::max<std::size_t>(1, histogram.counts.size()));
  auto* bars = new QCPBars(x, y);
  for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
    bars->addData(histogram.low + (static_cast<double>(i) + 0.5) * width, histogram.counts[i]);
  }
  bars->setWidth(width);
  bars->setPen(Qt::NoPen);
  bars->setBrush(curve_colour(theme, 0));
  const double most = histogram.counts.empty() ? 1.0 : *std::ranges::max_element(histogram.counts);
  x->setRange(histogram.low, histogram.high);
  y->setRange(0.0, 1.15 * std::max(1.0, most));
  if (histogram.mark) draw_mark(plot, rect, *histogram.mark, QString::fromStdString(histogram.mark_name), theme);
}

std::string number(double value) { return digits(value, "%.17g"); }

}  // namespace

void draw_scatter(QCustomPlot& plot, const report::ScatterPlot& scatter, Theme theme) {
  auto* rect = new QCPAxisRect(&plot);
  plot.plotLayout()->addElement(0, 0, rect);
  style_axes(*rect, theme);
  QCPAxis* const x = rect->axis(QCPAxis::atBottom);
  QCPAxis* const y = rect->axis(QCPAxis::atLeft);
  set_axis(*x, scatter.x);
  set_axis(*y, scatter.y);
  add_legend(plot, theme);
  bool found = false;
  for (std::size_t g = 0; g < scatter.groups.size(); ++g) {
    QCPGraph* const graph = add_points(plot, *rect, scatter.groups[g].points);
    const QColor colour = curve_colour(theme, static_cast<int>(g));
    graph->setName(QString::fromStdString(scatter.groups[g].name));
    graph->setLineStyle(QCPGraph::lsNone);
    const int size = scatter.groups[g].points.size() > few_points ? 5 : 9;
    graph->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, colour, colour, size));
    graph->addToLegend(plot.legend);
    if (scatter.groups[g].points.empty()) continue;
    graph->rescaleAxes(found);
    found = true;
  }
  if (!scatter.front.empty()) {
    QCPGraph* const front = add_points(plot, *rect, scatter.front);
    front->setName(QString::fromStdString(scatter.front_name));
    front->setPen(QPen(colours(theme).weak_text, 1, Qt::DashLine));
    front->addToLegend(plot.legend);
  }
  std::vector<double> across, up;
  for (const report::PointGroup& group : scatter.groups) {
    for (const report::Point& point : group.points) {
      across.push_back(point.x);
      up.push_back(point.y);
    }
  }
  give_room(*x, across);
  give_room(*y, up);
  widen(*x);
  widen(*y);
  if (scatter.backdrop) draw_backdrop(plot, *rect, *scatter.backdrop, theme);
}

void draw_histograms(QCustomPlot& plot, const std::vector<report::HistogramPlot>& histograms, Theme theme) {
  const int square = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(histograms.size()))));
  const int columns = std::max(1, std::min({square, in_a_row, plot.width() / narrowest}));
  const int rows = std::max(1, (static_cast<int>(histograms.size()) + columns - 1) / columns);
  const QSize room(plot.width() / columns, plot.height() / rows);
  for (int i = 0; i < static_cast<int>(histograms.size()); ++i) {
    auto* rect = new QCPAxisRect(&plot);
    plot.plotLayout()->addElement(i / columns, i % columns, rect);
    draw_histogram(plot, *rect, histograms[static_cast<std::size_t>(i)], room, theme);
  }
}

void draw_ring(QCustomPlot& plot, const report::Point& point, Theme theme) {
  for (int i = plot.itemCount() - 1; i >= 0; --i) {
    if (plot.item(i)->objectName() == QLatin1String(ring_name)) plot.removeItem(i);
  }
  auto* ring = new QCPItemTracer(&plot);
  ring->setObjectName(QLatin1String(ring_name));
  ring->setStyle(QCPItemTracer::tsCircle);
  ring->setSize(17);
  ring->setPen(QPen(colours(theme).text, 2));
  ring->position->setAxes(plot.axisRect()->axis(QCPAxis::atBottom), plot.axisRect()->axis(QCPAxis::atLeft));
  ring->position->setCoords(point.x, point.y);
}

std::string chart_table(const report::ScatterPlot& scatter, const std::vector<report::HistogramPlot>& histograms,
                        char separator) {
  const std::string by(1, separator);
  std::string text;
  if (!scatter.groups.empty()) {
    text = "group" + by + "name" + by + quoted(scatter.x.label) + by + quoted(scatter.y.label) + "\n";
    for (const report::PointGroup& group : scatter.groups) {
      for (const report::Point& point : group.points) {
        text += quoted(group.name) + by + quoted(point.label) + by + number(point.x) + by + number(point.y) + "\n";
      }
    }
  }
  if (!histograms.empty()) text += "name" + by + "from" + by + "to" + by + "count\n";
  for (const report::HistogramPlot& plot : histograms) {
    const double width = (plot.high - plot.low) / static_cast<double>(std::max<std::size_t>(1, plot.counts.size()));
    for (std::size_t i = 0; i < plot.counts.size(); ++i) {
      const double from = plot.low + static_cast<double>(i) * width;
      text += quoted(plot.title) + by + number(from) + by + number(from + width) + by + digits(plot.counts[i], "%.0f") + "\n";
    }
  }
  return text;
}

}  // namespace jointid::gui
