#include "gui/plot/plot_canvas.hpp"

#include <qcustomplot.h>

#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "gui/look/named.hpp"
#include "gui/look/theme.hpp"
#include "gui/plot/overlay.hpp"
#include "gui/plot/panel_drawing.hpp"
#include "gui/plot/picture.hpp"

namespace jointid::gui {
namespace {

constexpr double wheel_factor = 0.8;
constexpr int far_lines = 10;
constexpr int shortest_drag = 4;  // pixels

}  // namespace

PlotCanvas::PlotCanvas(const QString& hint, QWidget* parent) : QWidget(parent), hint_(hint), plot_(new QCustomPlot(this)) {
  named(plot_, "frf_canvas", tr("FRF plot"));
  plot_->setFocusPolicy(Qt::StrongFocus);
  plot_->setMinimumSize(200, 200);
  speak_numbers(*plot_);
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

void PlotCanvas::draw(const std::vector<Curve>& curves, View view, frf::Quantity quantity, bool decibel) {
  const bool anew = curves_.empty();
  curves_ = curves;
  view_ = view;
  quantity_ = quantity;
  decibel_ = decibel;
  if (anew) shown_.reset();
  if (cursor_ && !curves_.empty()) cursor_ = curves_.front().frequency_hz[nearest_line(curves_.front(), *cursor_)];
  redraw();
}

void PlotCanvas::set_bands(std::vector<ident::Range> excluded, std::optional<ident::Range> range) {
  excluded_ = std::move(excluded);
  range_ = range;
  redraw();
}

void PlotCanvas::set_marked(std::vector<double> marked_hz) {
  marked_hz_ = std::move(marked_hz);
  redraw();
}

Drawing PlotCanvas::drawing() const { return {curves_, view_, quantity_, shown_hz(), theme_of(palette()), decibel_}; }

void PlotCanvas::redraw() {
  plot_->clearItems();
  plot_->clearPlottables();
  plot_->plotLayout()->clear();
  plot_->legend = nullptr;
  const Theme theme = theme_of(palette());
  plot_->setBackground(colours(theme).background);
  plot_->selectionRect()->setPen(QPen(colours(theme).text));
  plot_->selectionRect()->setBrush(colours(theme).band);
  if (curves_.empty())
    draw_hint(*plot_, hint_, theme);
  else if (view_ == View::nyquist)
    draw_nyquist(*plot_, drawing());
  else
    draw_diagrams();
  show_cursor();
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void PlotCanvas::draw_diagrams() {
  draw_panels(*plot_, drawing());
  for (QCPAxisRect* rect : plot_->axisRects()) {
    draw_bands(*rect, excluded_, range_, span_of(curves_), theme_of(palette()));
    draw_marks(*rect, marked_hz_, theme_of(palette()));
  }
}

void PlotCanvas::show_cursor() {
  if (curves_.empty()) return;
  for (const auto& at : {cursor_, mark_hz_}) {
    if (at) draw_cursor(*plot_, *overlay_, drawing(), *at);
  }
}

void PlotCanvas::zoom_ordinates(double factor) {
  if (curves_.empty() || plot_->axisRectCount() == 0) return;
  plot_->axisRects().front()->axis(QCPAxis::atLeft)->scaleRange(factor);
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

ident::Range PlotCanvas::shown_ordinates() const {
  if (plot_->axisRectCount() == 0) return {};
  const QCPRange range = plot_->axisRects().front()->axis(QCPAxis::atLeft)->range();
  return {range.lower, range.upper};
}

/// The band that the cursor is in.
void PlotCanvas::drop_band() {
  for (const auto& [low, high] : excluded_) {
    if (cursor_ && *cursor_ >= low && *cursor_ <= high) return Q_EMIT band_unwanted(low, high);
  }
}

/// The curve nearest to the mouse, if it is near.
void PlotCanvas::hover(const QPointF& at) {
  constexpr double nearest_px = 12.0;
  double nearest = nearest_px;
  int found = -1;
  for (const QCPAxisRect* rect : plot_->axisRects()) {
    if (!rect->rect().contains(at.toPoint()) || view_ == View::nyquist) continue;
    const double x = rect->axis(QCPAxis::atBottom)->pixelToCoord(at.x());
    for (const QCPGraph* graph : rect->graphs()) {
      const auto point = graph->data()->findBegin(x);
      if (point == graph->data()->constEnd() || !std::isfinite(point->value)) continue;
      const double distance = std::abs(rect->axis(QCPAxis::atLeft)->coordToPixel(point->value) - at.y());
      if (distance >= nearest) continue;
      nearest = distance;
      found = static_cast<int>(curve_of(*graph));
    }
  }
  if (found == hovered_) return;
  hovered_ = found;
  Q_EMIT curve_hovered(found);
}

void PlotCanvas::move_cursor(double frequency_hz) {
  if (curves_.empty()) return;
  cursor_ = curves_.front().frequency_hz[nearest_line(curves_.front(), frequency_hz)];
  for (int i = plot_->itemCount() - 1; i >= 0; --i) {
    if (plot_->item(i)->layer() == overlay_) plot_->removeItem(i);
  }
  show_cursor();
  overlay_->replot();
}

std::optional<double> PlotCanvas::cursor_hz() const {
  const auto [low, high] = shown_hz();
  return !curves_.empty() && cursor_ && *cursor_ >= low && *cursor_ <= high ? cursor_ : std::nullopt;
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
  Q_EMIT range_changed();
  if (view_ == View::nyquist || curves_.empty()) return redraw();
  for (QCPAxisRect* rect : plot_->axisRects()) fit_axes(*rect, shown_hz());
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
  const auto on_line = [this](double hz) { return curves_.front().frequency_hz[nearest_line(curves_.front(), hz)]; };
  if (excluding_)
    Q_EMIT band_chosen(on_line(low), on_line(high));
  else
    show_range({low, high});
}

bool PlotCanvas::move_by(int key, bool far) {
  const std::vector<double>& axis = curves_.front().frequency_hz;
  const auto line = static_cast<std::ptrdiff_t>(nearest_line(curves_.front(), cursor_.value_or(shown_hz()[0])));
  const auto last = static_cast<std::ptrdiff_t>(axis.size()) - 1;
  const std::ptrdiff_t step = (key == Qt::Key_Left ? -1 : 1) * (far ? far_lines : 1);
  move_cursor(axis[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(line + step, 0, last))]);
  Q_EMIT cursor_moved(*cursor_);
  return true;
}

/// Keys that do not move.
bool PlotCanvas::press_other(int key) {
  switch (key) {
    case Qt::Key_M:
      mark_hz_ = mark_hz_ ? std::nullopt : cursor_;
      move_cursor(cursor_.value_or(shown_hz()[0]));
      Q_EMIT mark_changed();
      return true;
    case Qt::Key_Delete:
      drop_band();
      return true;
    case Qt::Key_PageDown:
    case Qt::Key_PageUp:
      Q_EMIT next_wanted(key == Qt::Key_PageDown ? 1 : -1);
      return true;
    default:
      return false;
  }
}

bool PlotCanvas::press(int key, bool far) {
  if (curves_.empty()) return false;
  switch (key) {
    case Qt::Key_Left:
    case Qt::Key_Right:
      return move_by(key, far);
    case Qt::Key_Up:
    case Qt::Key_Down:
      zoom_ordinates(key == Qt::Key_Up ? wheel_factor : 1.0 / wheel_factor);
      return true;
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
      return press_other(key);
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
    const auto* wheel = static_cast<QWheelEvent*>(event);
    const double factor = wheel->angleDelta().y() > 0 ? wheel_factor : 1.0 / wheel_factor;
    if ((wheel->modifiers() & Qt::ControlModifier) != 0)
      zoom_ordinates(factor);
    else
      zoom(factor);
    return true;
  }
  if (event->type() == QEvent::MouseMove && !rects.isEmpty() && view_ != View::nyquist && !curves_.empty()) {
    const double x = rects.front()->axis(QCPAxis::atBottom)->pixelToCoord(static_cast<QMouseEvent*>(event)->position().x());
    if (x >= shown_hz()[0] && x <= shown_hz()[1]) {
      move_cursor(x);
      Q_EMIT cursor_moved(*cursor_);
    }
    hover(static_cast<QMouseEvent*>(event)->position());
  }
  return false;
}

void PlotCanvas::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && plot_ != nullptr) redraw();
}

QByteArray PlotCanvas::picture(const QString& ending) const { return picture_of(*plot_, ending); }

}  // namespace jointid::gui
