#include "gui/plot/panel_drawing.hpp"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "gui/look/said.hpp"

namespace jointid::gui {
namespace {

constexpr std::size_t most_in_legend = 10;
constexpr const char* curve_property = "curve";

/// Axes of pages, and names of quantities, that the window has in other languages.
[[maybe_unused]] constexpr const char* axis_words[] = {QT_TRANSLATE_NOOP("Said", "frequency (Hz)"),
                                                       QT_TRANSLATE_NOOP("Said", "time (s)"),
                                                       QT_TRANSLATE_NOOP("Said", "phase (°)"),
                                                       QT_TRANSLATE_NOOP("Said", "mode"),
                                                       QT_TRANSLATE_NOOP("Said", "force (N)"),
                                                       QT_TRANSLATE_NOOP("Said", "singular value"),
                                                       QT_TRANSLATE_NOOP("Said", "shape"),
                                                       QT_TRANSLATE_NOOP("Said", "relative velocity (m/s)"),
                                                       QT_TRANSLATE_NOOP("Said", "radius"),
                                                       QT_TRANSLATE_NOOP("Said", "over the amplitude"),
                                                       QT_TRANSLATE_NOOP("Said", "order (pole pairs)"),
                                                       QT_TRANSLATE_NOOP("Said", "of critical (%)"),
                                                       QT_TRANSLATE_NOOP("Said", "mean square λ"),
                                                       QT_TRANSLATE_NOOP("Said", "mean ln distance"),
                                                       QT_TRANSLATE_NOOP("Said", "loop"),
                                                       QT_TRANSLATE_NOOP("Said", "lag (s)"),
                                                       QT_TRANSLATE_NOOP("Said", "frequency lines used"),
                                                       QT_TRANSLATE_NOOP("Said", "displacement (m)"),
                                                       QT_TRANSLATE_NOOP("Said", "dimension"),
                                                       QT_TRANSLATE_NOOP("Said", "coordinates"),
                                                       QT_TRANSLATE_NOOP("Said", "condition number"),
                                                       QT_TRANSLATE_NOOP("Said", "coherence"),
                                                       QT_TRANSLATE_NOOP("Said", "channel"),
                                                       QT_TRANSLATE_NOOP("Said", "sample"),
                                                       QT_TRANSLATE_NOOP("Said", "amplitude (m)"),
                                                       QT_TRANSLATE_NOOP("Said", "receptance"),
                                                       QT_TRANSLATE_NOOP("Said", "mobility"),
                                                       QT_TRANSLATE_NOOP("Said", "accelerance"),
                                                       QT_TRANSLATE_NOOP("Said", "time of one solution"),
                                                       QT_TRANSLATE_NOOP("Said", "rms relative error (median)"),
                                                       QT_TRANSLATE_NOOP("Said", "value / value of the solution"),
                                                       QT_TRANSLATE_NOOP("Said", "objective"),
                                                       QT_TRANSLATE_NOOP("Said", "iteration"),
                                                       QT_TRANSLATE_NOOP("Said", "displacement"),
                                                       QT_TRANSLATE_NOOP("Said", "amplitude"),
                                                       QT_TRANSLATE_NOOP("Said", "force"),
                                                       QT_TRANSLATE_NOOP("Said", "energy"),
                                                       QT_TRANSLATE_NOOP("Said", "time"),
                                                       QT_TRANSLATE_NOOP("Said", "frequency"),
                                                       QT_TRANSLATE_NOOP("Said", "slipped share h of the stiffness area")};

QVector<QCPGraphData> points(const std::vector<double>& x, const std::vector<double>& y) {
  QVector<QCPGraphData> data;
  data.reserve(static_cast<qsizetype>(y.size()));
  for (std::size_t i = 0; i < y.size(); ++i) data.push_back(QCPGraphData(x[i], y[i]));
  return data;
}

void draw_degrees(QCPAxis* axis, double top) {
  auto ticks = QSharedPointer<QCPAxisTickerFixed>::create();
  ticks->setTickStep(90.0);
  ticks->setScaleStrategy(QCPAxisTickerFixed::ssMultiples);
  axis->setTicker(ticks);
  axis->setRange(top - 370.0, top + 10.0);
}

QPen pen_of(const Drawing& drawing, std::size_t curve) {
  const Qt::PenStyle line = drawing.curves[curve].is_measured ? Qt::SolidLine : Qt::DashLine;
  return QPen(curve_colour(drawing.theme, static_cast<int>(curve)), 1.0, line);
}

void add_panel(QCustomPlot& plot, const Drawing& drawing, int row, const Panel& panel, bool last) {
  auto* rect = new QCPAxisRect(&plot);
  plot.plotLayout()->addElement(row, 0, rect);
  QCPAxis* const x = rect->axis(QCPAxis::atBottom);
  QCPAxis* const y = rect->axis(QCPAxis::atLeft);
  style_axes(*rect, drawing.theme);
  y->setLabel(axis_text(panel.label));
  if (last) x->setLabel(Said::tr("frequency (Hz)"));
  x->setTickLabels(last);
  if (panel.logarithmic) {
    y->setScaleType(QCPAxis::stLogarithmic);
    y->setTicker(QSharedPointer<QCPAxisTickerLog>::create());
    y->setNumberFormat(QStringLiteral("eb"));
    y->setNumberPrecision(0);
  }
  for (std::size_t i = 0; i < panel.ordinates.size(); ++i) {
    if (panel.ordinates[i].empty()) continue;
    QCPGraph* const graph = plot.addGraph(x, y);
    graph->setName(QString::fromStdString(drawing.curves[i].name));
    graph->setProperty(curve_property, static_cast<qulonglong>(i));
    graph->setPen(pen_of(drawing, i));
    graph->data()->set(points(drawing.curves[i].frequency_hz, panel.ordinates[i]), true);
  }
  if (panel.label == phase_label) rect->setProperty("top_deg", panel.top);
  rect->setProperty("unity", panel.label == coherence_label);
  fit_axes(*rect, drawing.shown_hz);
}

/// No room for numbers that are not there; all left ends below each other.
void align(const QList<QCPAxisRect*>& rects, QCustomPlot& plot) {
  auto* margins = new QCPMarginGroup(&plot);
  for (QCPAxisRect* rect : rects) rect->setMarginGroup(QCP::msLeft | QCP::msRight, margins);
  for (QCPAxisRect* rect : rects) {
    if (rect == rects.back()) continue;
    rect->setAutoMargins(QCP::msLeft | QCP::msRight | QCP::msTop);
    rect->setMargins(QMargins(0, 0, 0, 6));
  }
  if (rects.size() > 1) plot.plotLayout()->setRowStretchFactor(0, 2.0);
  plot.plotLayout()->setRowSpacing(2);
}

QVector<QCPCurveData> locus(const Curve& curve, const Drawing& drawing) {
  const auto [low, high] = drawing.shown_hz;
  const std::vector<Complex> values = converted(curve, drawing.quantity);
  QVector<QCPCurveData> data;
  for (std::size_t line = 0; line < values.size(); ++line) {
    const double f = curve.frequency_hz[line];
    if (f >= low && f <= high) data.push_back(QCPCurveData(static_cast<double>(line), values[line].real(), values[line].imag()));
  }
  return data;
}

}  // namespace

/// Ticks with as many digits as tell neighbours apart: 1.08547 to 1.08548 does not repeat one number.
class DistinctTicker : public QCPAxisTicker {
 protected:
  double getTickStep(const QCPRange& range) override { return step_ = QCPAxisTicker::getTickStep(range); }
  QString getTickLabel(double tick, const QLocale& locale, QChar format, int precision) override {
    constexpr int most_digits = 15;
    const double steps = step_ > 0.0 ? std::abs(tick) / step_ : 0.0;
    const int needed = steps > 1.0 ? static_cast<int>(std::ceil(std::log10(steps))) + 2 : 0;
    return QCPAxisTicker::getTickLabel(tick, locale, format, std::clamp(needed, precision, most_digits));
  }

 private:
  double step_ = 0.0;
};

void speak_numbers(QCustomPlot& plot) {
  QLocale plain = QLocale::c();
  plain.setNumberOptions(QLocale::OmitGroupSeparator);
  plot.setLocale(plain);
}

QString axis_text(const std::string& label) {
  const std::size_t unit = label.rfind(" (");
  const QString whole = said(label.c_str());
  if (unit == std::string::npos || whole != QString::fromStdString(label)) return whole;
  return said(label.substr(0, unit).c_str()) + QString::fromStdString(label.substr(unit));
}

std::size_t curve_of(const QCPGraph& graph) { return graph.property(curve_property).toULongLong(); }

void tell_ticks_apart(QCPAxis& axis) { axis.setTicker(QSharedPointer<DistinctTicker>::create()); }

void style_axes(QCPAxisRect& rect, Theme theme) {
  const Colours use = colours(theme);
  for (QCPAxis* axis : rect.axes()) {
    tell_ticks_apart(*axis);
    axis->setBasePen(QPen(use.weak_text));
    axis->setTickPen(QPen(use.weak_text));
    axis->setSubTickPen(QPen(use.weak_text));
    axis->setTickLabelColor(use.text);
    axis->setLabelColor(use.text);
    axis->grid()->setPen(QPen(use.grid, 1, Qt::DotLine));
    axis->grid()->setZeroLinePen(QPen(use.grid));
  }
}

void draw_hint(QCustomPlot& plot, const QString& hint, Theme theme) {
  auto* text = new QCPTextElement(&plot, hint, QFont(plot.font().family(), 11));
  text->setTextColor(colours(theme).weak_text);
  text->setTextFlags(Qt::AlignCenter | Qt::TextWordWrap);
  text->setMaximumSize(QWIDGETSIZE_MAX / 2, QWIDGETSIZE_MAX / 2);  // all of the plot: the default is the size of the text
  plot.plotLayout()->addElement(0, 0, text);
}

void add_legend(QCustomPlot& plot, Theme theme) {
  auto* legend = new QCPLegend;
  plot.legend = legend;
  plot.plotLayout()->insertRow(0);
  plot.plotLayout()->addElement(0, 0, legend);
  plot.plotLayout()->setRowStretchFactor(0, 0.001);
  legend->setLayer(QStringLiteral("legend"));
  legend->setFillOrder(QCPLayoutGrid::foColumnsFirst);
  legend->setWrap(2);
  legend->setBrush(Qt::NoBrush);
  legend->setBorderPen(Qt::NoPen);
  legend->setTextColor(colours(theme).text);
  legend->setMargins(QMargins(60, 0, 0, 0));
}

void wrap_legend(QCustomPlot& plot) {
  constexpr int margins = 80, icon = 50;  // pixels
  if (plot.legend == nullptr || plot.legend->itemCount() == 0) return;
  int widest = 0;
  for (int i = 0; i < plot.legend->itemCount(); ++i) {
    auto* const item = qobject_cast<QCPPlottableLegendItem*>(plot.legend->item(i));
    if (item != nullptr)
      widest = std::max(widest, QFontMetrics(plot.legend->font()).horizontalAdvance(item->plottable()->name()));
  }
  plot.legend->setWrap(std::clamp((plot.width() - margins) / (widest + icon), 1, plot.legend->itemCount()));
  plot.legend->setFillOrder(QCPLayoutGrid::foColumnsFirst, true);
}

void draw_panels(QCustomPlot& plot, const Drawing& drawing) {
  const std::vector<Panel> all = panels(drawing.curves, drawing.view, drawing.quantity, drawing.decibel);
  for (std::size_t row = 0; row < all.size(); ++row) {
    add_panel(plot, drawing, static_cast<int>(row), all[row], row + 1 == all.size());
  }
  const QList<QCPAxisRect*> rects = plot.axisRects();
  align(rects, plot);
  if (drawing.curves.size() > most_in_legend || rects.isEmpty()) return;
  add_legend(plot, drawing.theme);
  for (QCPGraph* graph : rects.front()->graphs()) graph->addToLegend(plot.legend);
}

void draw_nyquist(QCustomPlot& plot, const Drawing& drawing) {
  auto* rect = new QCPAxisRect(&plot);
  plot.plotLayout()->addElement(0, 0, rect);
  style_axes(*rect, drawing.theme);
  const QString unit = QString::fromStdString(unit_of(drawing.curves, drawing.quantity));
  QCPAxis* const x = rect->axis(QCPAxis::atBottom);
  QCPAxis* const y = rect->axis(QCPAxis::atLeft);
  x->setLabel(Said::tr("real part (%1)").arg(unit));
  y->setLabel(Said::tr("imaginary part (%1)").arg(unit));
  for (std::size_t i = 0; i < drawing.curves.size(); ++i) {
    auto* curve = new QCPCurve(x, y);
    curve->setPen(pen_of(drawing, i));
    curve->data()->set(locus(drawing.curves[i], drawing), true);
    curve->rescaleAxes(i > 0);
  }
  x->scaleRange(1.1);
  y->scaleRange(1.1);
  y->setScaleRatio(x, 1.0);
}

void give_room(QCPAxis& axis, const std::vector<double>& values) {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  if (!(least == most)) return;
  constexpr double share = 0.2, factor = 10.0;
  const double room = most == 0.0 ? 1.0 : share * std::abs(most);
  if (axis.scaleType() == QCPAxis::stLogarithmic && most > 0.0)
    axis.setRange(most / factor, most * factor);
  else
    axis.setRange(most - room, most + room);
}

void fit_axes(QCPAxisRect& rect, const ident::Range& shown_hz) {
  QCPAxis* const x = rect.axis(QCPAxis::atBottom);
  QCPAxis* const y = rect.axis(QCPAxis::atLeft);
  x->setRange(shown_hz[0], shown_hz[1]);
  if (const QVariant top = rect.property("top_deg"); top.isValid()) return draw_degrees(y, top.toDouble());
  if (rect.property("unity").toBool()) return y->setRange(0.0, 1.02);
  const bool linear = y->scaleType() == QCPAxis::stLinear;
  QCPRange all;
  bool any = false;
  for (const QCPGraph* graph : rect.graphs()) {
    bool found = false;
    const QCPRange one = graph->getValueRange(found, linear ? QCP::sdBoth : QCP::sdPositive, x->range());
    if (!found) continue;
    if (any)
      all.expand(one);
    else
      all = one;
    any = true;
  }
  if (!any) return;
  if (all.lower == all.upper) return give_room(*y, {all.lower});
  y->setRange(all);
  if (linear) y->scaleRange(1.1);
}

ident::Range span_of(const std::vector<Curve>& curves) {
  ident::Range span = {std::numeric_limits<double>::infinity(), 0.0};
  for (const Curve& curve : curves) {
    span = {std::min(span[0], curve.frequency_hz.front()), std::max(span[1], curve.frequency_hz.back())};
  }
  if (!(span[0] < span[1])) span = {span[0] - 0.5, span[0] + 0.5};
  return span;
}

}  // namespace jointid::gui
