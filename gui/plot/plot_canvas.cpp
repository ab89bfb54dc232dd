#include "gui/plot/plot_canvas.hpp"

#include <qcustomplot.h>

#include <QBuffer>
#include <QPdfWriter>
#include <QSvgGenerator>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "gui/look/named.hpp"
#include "gui/look/theme.hpp"

namespace jointid::gui {
namespace {

constexpr double wheel_factor = 0.8;
constexpr int far_lines = 10;
constexpr int shortest_drag = 4;  // pixels
constexpr std::size_t most_in_legend = 10;

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

ident::Range span_of(const std::vector<Curve>& curves) {
  ident::Range span = {std::numeric_limits<double>::infinity(), 0.0};
  for (const Curve& curve : curves) {
    span = {std::min(span[0], curve.frequency_hz.front()), std::max(span[1], curve.frequency_hz.back())};
  }
  if (!(span[0] < span[1])) span = {span[0] - 0.5, span[0] + 0.5};
  return span;
}

}  // namespace

PlotCanvas::PlotCanvas(const QString& hint, QWidget* parent) : QWidget(parent), hint_(hint), plot_(new QCustomPlot(this)) {
  named(plot_, "frf_canvas", tr("FRF plot"));
  plot_->setFocusPolicy(Qt::StrongFocus);
  plot_->setMinimumSize(200, 160);
  plot_->setAutoAddPlottableToLegend(false);
  plot_->setPlottingHint(QCP::phFastPolylines);
  plot_->addLayer(QStringLiteral("overlay_items"), nullptr, QCustomPlot::limAbove);
  overlay_ = plot_->layer(QStringLiteral("overlay_items"));
  overlay_->setMode(QCPLayer::lmBuffered);  // the cursor moves without the curves being drawn again
  plot_->setSelectionRectMode(QCP::srmCustom);
  plot_->installEventFilter(this);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(plot_);
  connect(plot_->selectionRect(), &QCPSelectionRect::accepted, this, &PlotCanvas::end_drag);
  connect(plot_, &QCustomPlot::mouseDoubleClick, this, &PlotCanvas::show_all);
  redraw();
}

void PlotCanvas::draw(const std::vector<Curve>& curves, View view, frf::Quantity quantity) {
  const bool anew = curves_.empty();
  curves_ = curves;
  view_ = view;
  quantity_ = quantity;
  if (anew) shown_.reset();
  redraw();
}

void PlotCanvas::set_bands(std::vector<ident::Range> excluded, std::optional<ident::Range> range) {
  excluded_ = std::move(excluded);
  range_ = range;
  redraw();
}

void PlotCanvas::redraw() {
  plot_->clearItems();
  plot_->clearPlottables();
  plot_->plotLayout()->clear();
  plot_->legend = nullptr;
  const Colours use = colours(theme_of(palette()));
  plot_->setBackground(use.background);
  plot_->selectionRect()->setPen(QPen(use.text));
  plot_->selectionRect()->setBrush(use.band);
  if (curves_.empty())
    draw_hint();
  else if (view_ == View::nyquist)
    draw_nyquist();
  else
    draw_panels();
  draw_cursor();
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void PlotCanvas::draw_hint() {
  auto* text = new QCPTextElement(plot_, hint_, QFont(font().family(), 11));
  text->setTextColor(colours(theme_of(palette())).weak_text);
  plot_->plotLayout()->addElement(0, 0, text);
}

void PlotCanvas::style(QCPAxisRect* rect) const {
  const Colours use = colours(theme_of(palette()));
  for (QCPAxis* axis : rect->axes()) {
    axis->setBasePen(QPen(use.weak_text));
    axis->setTickPen(QPen(use.weak_text));
    axis->setSubTickPen(QPen(use.weak_text));
    axis->setTickLabelColor(use.text);
    axis->setLabelColor(use.text);
    axis->grid()->setPen(QPen(use.grid, 1, Qt::DotLine));
    axis->grid()->setZeroLinePen(QPen(use.grid));
  }
}

void PlotCanvas::add_panel(int row, const Panel& panel, bool last) {
  auto* rect = new QCPAxisRect(plot_);
  plot_->plotLayout()->addElement(row, 0, rect);
  QCPAxis* const x = rect->axis(QCPAxis::atBottom);
  QCPAxis* const y = rect->axis(QCPAxis::atLeft);
  style(rect);
  y->setLabel(QString::fromStdString(panel.label));
  if (last) x->setLabel(tr("frequency (Hz)"));
  x->setTickLabels(last);
  if (panel.logarithmic) {
    y->setScaleType(QCPAxis::stLogarithmic);
    y->setTicker(QSharedPointer<QCPAxisTickerLog>::create());
    y->setNumberFormat(QStringLiteral("eb"));
    y->setNumberPrecision(0);
  }
  for (std::size_t i = 0; i < panel.ordinates.size(); ++i) {
    if (panel.ordinates[i].empty()) continue;
    QCPGraph* const graph = plot_->addGraph(x, y);
    graph->setName(QString::fromStdString(curves_[i].name));
    const Qt::PenStyle line = curves_[i].is_measured ? Qt::SolidLine : Qt::DashLine;
    graph->setPen(QPen(curve_colour(theme_of(palette()), static_cast<int>(i)), 1.0, line));
    graph->data()->set(points(curves_[i].frequency_hz, panel.ordinates[i]), true);
  }
  if (panel.label == phase_label) rect->setProperty("top_deg", panel.top);
  rect->setProperty("unity", panel.label == coherence_label);
  fit_axes(rect);
  draw_bands(rect);
}

/// The shown frequencies, and all that the curves do there.
void PlotCanvas::fit_axes(QCPAxisRect* rect) const {
  QCPAxis* const x = rect->axis(QCPAxis::atBottom);
  QCPAxis* const y = rect->axis(QCPAxis::atLeft);
  x->setRange(shown_hz()[0], shown_hz()[1]);
  if (const QVariant top = rect->property("top_deg"); top.isValid()) return draw_degrees(y, top.toDouble());
  if (rect->property("unity").toBool()) return y->setRange(0.0, 1.02);
  bool found = false;
  for (QCPGraph* graph : rect->graphs()) {
    graph->rescaleValueAxis(found, true);
    found = true;
  }
  if (y->scaleType() == QCPAxis::stLinear) y->scaleRange(1.1);
}

void PlotCanvas::draw_panels() {
  const std::vector<Panel> all = panels(curves_, view_, quantity_);
  for (std::size_t row = 0; row < all.size(); ++row) add_panel(static_cast<int>(row), all[row], row + 1 == all.size());
  auto* margins = new QCPMarginGroup(plot_);
  const QList<QCPAxisRect*> rects = plot_->axisRects();
  for (QCPAxisRect* rect : rects) rect->setMarginGroup(QCP::msLeft | QCP::msRight, margins);
  for (QCPAxisRect* rect : rects) {
    if (rect == rects.back()) continue;
    rect->setAutoMargins(QCP::msLeft | QCP::msRight | QCP::msTop);  // no room for numbers that are not there
    rect->setMargins(QMargins(0, 0, 0, 6));
  }
  if (rects.size() > 1) plot_->plotLayout()->setRowStretchFactor(0, 2.0);
  plot_->plotLayout()->setRowSpacing(2);
  if (curves_.size() > most_in_legend || rects.isEmpty()) return;
  add_legend();
  QCPLegend* const legend = plot_->legend;
  for (QCPGraph* graph : rects.front()->graphs()) graph->addToLegend(legend);
}

/// Names in lines of two above the diagrams, where they hide nothing.
void PlotCanvas::add_legend() {
  auto* legend = new QCPLegend;
  plot_->legend = legend;
  plot_->plotLayout()->insertRow(0);
  plot_->plotLayout()->addElement(0, 0, legend);
  plot_->plotLayout()->setRowStretchFactor(0, 0.001);
  legend->setLayer(QStringLiteral("legend"));
  legend->setFillOrder(QCPLayoutGrid::foColumnsFirst);
  legend->setWrap(2);
  legend->setBrush(Qt::NoBrush);
  legend->setBorderPen(Qt::NoPen);
  legend->setTextColor(colours(theme_of(palette())).text);
  legend->setMargins(QMargins(60, 0, 0, 0));
}

void PlotCanvas::draw_nyquist() {
  auto* rect = new QCPAxisRect(plot_);
  plot_->plotLayout()->addElement(0, 0, rect);
  style(rect);
  const QString unit = QString::fromStdString(unit_of(curves_, quantity_));
  QCPAxis* const x = rect->axis(QCPAxis::atBottom);
  QCPAxis* const y = rect->axis(QCPAxis::atLeft);
  x->setLabel(tr("real part (%1)").arg(unit));
  y->setLabel(tr("imaginary part (%1)").arg(unit));
  for (std::size_t i = 0; i < curves_.size(); ++i) {
    auto* curve = new QCPCurve(x, y);
    const auto [low, high] = shown_hz();
    QVector<QCPCurveData> data;
    const std::vector<Complex> values = converted(curves_[i], quantity_);
    for (std::size_t line = 0; line < values.size(); ++line) {
      const double f = curves_[i].frequency_hz[line];
      if (f >= low && f <= high)
        data.push_back(QCPCurveData(static_cast<double>(line), values[line].real(), values[line].imag()));
    }
    const Qt::PenStyle line = curves_[i].is_measured ? Qt::SolidLine : Qt::DashLine;
    curve->setPen(QPen(curve_colour(theme_of(palette()), static_cast<int>(i)), 1.0, line));
    curve->data()->set(data, true);
    curve->rescaleAxes(i > 0);
  }
  x->scaleRange(1.1);
  y->scaleRange(1.1);
  y->setScaleRatio(x, 1.0);
}

void PlotCanvas::draw_bands(QCPAxisRect* rect) {
  const Colours use = colours(theme_of(palette()));
  const auto add = [&](double low, double high, const QColor& colour) {
    auto* band = new QCPItemRect(plot_);
    band->setClipAxisRect(rect);
    band->setLayer(QStringLiteral("background"));
    band->setPen(Qt::NoPen);
    band->setBrush(colour);
    for (QCPItemPosition* corner : {band->topLeft, band->bottomRight}) {
      corner->setAxisRect(rect);
      corner->setTypeX(QCPItemPosition::ptPlotCoords);
      corner->setTypeY(QCPItemPosition::ptAxisRectRatio);
      corner->setAxes(rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atLeft));
    }
    band->topLeft->setCoords(low, 0.0);
    band->bottomRight->setCoords(high, 1.0);
  };
  for (const auto& [low, high] : excluded_) add(low, high, use.band);
  if (!range_) return;
  QColor outside = use.weak_text;
  outside.setAlpha(40);
  const ident::Range span = span_of(curves_);
  if (span[0] < (*range_)[0]) add(span[0], (*range_)[0], outside);
  if (span[1] > (*range_)[1]) add((*range_)[1], span[1], outside);
}

void PlotCanvas::draw_cursor() {
  if (!cursor_ || curves_.empty()) return;
  const Colours use = colours(theme_of(palette()));
  if (view_ == View::nyquist) {
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      const std::size_t line = nearest_line(curves_[i], *cursor_);
      const Complex value = curves_[i].values[line] * frf::from_receptance(quantity_, curves_[i].frequency_hz[line]);
      auto* mark = new QCPItemTracer(plot_);
      mark->setLayer(overlay_);
      mark->setStyle(QCPItemTracer::tsCircle);
      mark->setSize(9);
      mark->setPen(QPen(use.text));
      mark->setBrush(curve_colour(theme_of(palette()), static_cast<int>(i)));
      mark->position->setCoords(value.real(), value.imag());
    }
    return;
  }
  for (QCPAxisRect* rect : plot_->axisRects()) {
    auto* line = new QCPItemStraightLine(plot_);
    line->setLayer(overlay_);
    line->setClipAxisRect(rect);
    line->setPen(QPen(use.text, 1, Qt::DashLine));
    for (QCPItemPosition* point : {line->point1, line->point2}) {
      point->setAxisRect(rect);
      point->setTypeX(QCPItemPosition::ptPlotCoords);
      point->setTypeY(QCPItemPosition::ptAxisRectRatio);
      point->setAxes(rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atLeft));
    }
    line->point1->setCoords(*cursor_, 0.0);
    line->point2->setCoords(*cursor_, 1.0);
  }
}

void PlotCanvas::move_cursor(double frequency_hz) {
  if (curves_.empty()) return;
  cursor_ = curves_.front().frequency_hz[nearest_line(curves_.front(), frequency_hz)];
  for (int i = plot_->itemCount() - 1; i >= 0; --i) {
    if (plot_->item(i)->layer() == overlay_) plot_->removeItem(i);
  }
  draw_cursor();
  overlay_->replot();
}

ident::Range PlotCanvas::shown_hz() const { return shown_ ? *shown_ : span_of(curves_); }

void PlotCanvas::show_range(const ident::Range& range) {
  if (curves_.empty() || !(range[0] < range[1])) return;
  const ident::Range span = span_of(curves_);
  shown_ = {std::max(range[0], span[0]), std::min(range[1], span[1])};
  if (!((*shown_)[0] < (*shown_)[1])) shown_.reset();
  fit_all();
}

void PlotCanvas::show_all() {
  shown_.reset();
  fit_all();
}

/// Of diagrams over frequency the curves stay; a Nyquist plot holds only what is shown.
void PlotCanvas::fit_all() {
  if (view_ == View::nyquist || curves_.empty()) return redraw();
  for (QCPAxisRect* rect : plot_->axisRects()) fit_axes(rect);
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void PlotCanvas::zoom(double factor) {
  if (curves_.empty()) return;
  const auto [low, high] = shown_hz();
  const double middle = cursor_ && *cursor_ > low && *cursor_ < high ? *cursor_ : (low + high) / 2.0;
  show_range({middle - (middle - low) * factor, middle + (high - middle) * factor});
}

void PlotCanvas::end_drag(const QRect& rectangle) {
  const QList<QCPAxisRect*> rects = plot_->axisRects();
  if (curves_.empty() || rects.isEmpty() || view_ == View::nyquist || std::abs(rectangle.width()) < shortest_drag) return;
  const QCPAxis* const x = rects.front()->axis(QCPAxis::atBottom);
  const QRect normal = rectangle.normalized();
  const ident::Range span = span_of(curves_);
  const double low = std::max(span[0], x->pixelToCoord(normal.left())), high = std::min(span[1], x->pixelToCoord(normal.right()));
  if (!(low < high)) return;
  if (excluding_)
    Q_EMIT band_chosen(low, high);
  else
    show_range({low, high});
}

bool PlotCanvas::press(int key, bool far) {
  if (curves_.empty()) return false;
  const std::vector<double>& axis = curves_.front().frequency_hz;
  const auto line = static_cast<std::ptrdiff_t>(nearest_line(curves_.front(), cursor_.value_or(shown_hz()[0])));
  const auto last = static_cast<std::ptrdiff_t>(axis.size()) - 1;
  const std::ptrdiff_t step = (key == Qt::Key_Left ? -1 : 1) * (far ? far_lines : 1);
  switch (key) {
    case Qt::Key_Left:
    case Qt::Key_Right: {
      const auto next = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(line + step, 0, last));
      move_cursor(axis[next]);
      Q_EMIT cursor_moved(*cursor_);
      return true;
    }
    case Qt::Key_Plus:
      zoom(wheel_factor);
      return true;
    case Qt::Key_Minus:
      zoom(1.0 / wheel_factor);
      return true;
    case Qt::Key_Home:
      show_all();
      return true;
    default:
      return false;
  }
}

bool PlotCanvas::eventFilter(QObject* watched, QEvent* event) {
  if (watched != plot_) return QWidget::eventFilter(watched, event);
  const QList<QCPAxisRect*> rects = plot_->axisRects();
  if (event->type() == QEvent::KeyPress) {
    const auto* key = static_cast<QKeyEvent*>(event);
    return press(key->key(), (key->modifiers() & Qt::ShiftModifier) != 0);
  }
  if (event->type() == QEvent::Wheel && !rects.isEmpty()) {
    zoom(static_cast<QWheelEvent*>(event)->angleDelta().y() > 0 ? wheel_factor : 1.0 / wheel_factor);
    return true;
  }
  if (event->type() == QEvent::MouseMove && !rects.isEmpty() && view_ != View::nyquist && !curves_.empty()) {
    const double x = rects.front()->axis(QCPAxis::atBottom)->pixelToCoord(static_cast<QMouseEvent*>(event)->position().x());
    if (x >= shown_hz()[0] && x <= shown_hz()[1]) {
      move_cursor(x);
      Q_EMIT cursor_moved(*cursor_);
    }
  }
  return false;
}

void PlotCanvas::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && plot_ != nullptr) redraw();
}

QByteArray PlotCanvas::picture(const QString& ending) const {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  const QSize size = plot_->size();
  if (ending == QLatin1String("png")) {
    plot_->toPixmap(size.width(), size.height(), 2.0).save(&buffer, "PNG");
  } else if (ending == QLatin1String("svg")) {
    QSvgGenerator device;
    device.setOutputDevice(&buffer);
    device.setSize(size);
    device.setViewBox(QRect(QPoint(0, 0), size));
    QCPPainter painter(&device);
    painter.setMode(QCPPainter::pmVectorized);
    plot_->toPainter(&painter, size.width(), size.height());
  } else {
    QPdfWriter device(&buffer);
    constexpr int dpi = 96;
    device.setResolution(dpi);
    device.setPageSize(QPageSize(QSizeF(size) / dpi, QPageSize::Inch, QString(), QPageSize::ExactMatch));
    device.setPageMargins(QMarginsF(0, 0, 0, 0));
    QCPPainter painter(&device);
    painter.setMode(QCPPainter::pmVectorized);
    plot_->toPainter(&painter, size.width(), size.height());
  }
  return buffer.data();
}

}  // namespace jointid::gui
