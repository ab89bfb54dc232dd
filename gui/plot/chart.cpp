#include "gui/plot/chart.hpp"

#include <qcustomplot.h>

#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/look/named.hpp"
#include "gui/plot/chart_drawing.hpp"
#include "gui/plot/curve_drawing.hpp"
#include "gui/plot/panel_drawing.hpp"
#include "gui/plot/saving_row.hpp"

namespace jointid::gui {
namespace {

constexpr double zoom_factor = 1.4;
constexpr int least_drag_px = 4;
constexpr int least_width_px = 200, least_height_px = 200;

/// So that axes below each other, and the legend above them, can be read.
int least_height(const QCustomPlot& plot) {
  const int legend = plot.legend == nullptr ? 0 : plot.legend->rowCount(),
            panels = plot.plotLayout()->rowCount() - (legend > 0 ? 1 : 0);
  return std::max(least_height_px, 60 + 20 * legend + std::max(140, 85 * panels));
}

}  // namespace

Chart::Chart(const char* name, const QString& accessible_name, const QString& hint, QWidget* parent)
    : QWidget(parent), hint_(hint), plot_(new QCustomPlot(this)) {
  setAccessibleName(accessible_name);
  named(plot_, name, accessible_name);
  speak_numbers(*plot_);
  plot_->setFocusPolicy(Qt::StrongFocus);
  plot_->setMinimumSize(least_width_px, least_height_px);
  plot_->setAutoAddPlottableToLegend(false);
  plot_->setMouseTracking(true);
  plot_->installEventFilter(this);
  readout_ = named(new QLabel, "chart_readout", tr("The chosen point"));
  readout_->setTextFormat(Qt::PlainText);
  readout_->setWordWrap(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(plot_, 1);
  add_saving_row(
      *column, readout_, "chart", [this] { copy_plot(saveable()); },
      [this] { ask_and_save(this, saveable(), inputs_, plot_->objectName() + QStringLiteral(".png")); });
  redraw();
}

Saveable Chart::saveable() const {
  return {[this](const QString& ending) { return picture_of(*plot_, ending); },
          [this](char separator) {
            return curves_.empty() ? chart_table(scatter_, histograms_, separator) : curve_table(curves_, separator);
          }};
}

void Chart::draw(report::ScatterPlot plot) {
  forget();
  scatter_ = std::move(plot);
  redraw();
}

void Chart::draw(std::vector<report::HistogramPlot> plots) {
  forget();
  histograms_ = std::move(plots);
  redraw();
}

void Chart::draw(std::vector<report::CurvePlot> plots) {
  forget();
  curves_ = std::move(plots);
  redraw();
}

void Chart::clear() {
  forget();
  zoomed_ = false;
  redraw();
}

void Chart::forget() {
  scatter_ = {};
  histograms_.clear();
  curves_.clear();
  chosen_.reset();
  readout_->clear();
}

void Chart::let_zoom() {
  may_zoom_ = true;
  plot_->setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
}

std::array<double, 2> Chart::shown() const {
  if (plot_->axisRectCount() == 0) return {};
  const QCPRange range = plot_->axisRects().front()->axis(QCPAxis::atBottom)->range();
  return {range.lower, range.upper};
}

void Chart::show_all() {
  zoomed_ = false;
  redraw();
}

void Chart::redraw() {
  const std::array<double, 2> before = shown();
  plot_->clearItems();
  plot_->clearPlottables();
  plot_->plotLayout()->clear();
  plot_->legend = nullptr;
  const Theme theme = theme_of(palette());
  plot_->setBackground(colours(theme).background);
  if (!scatter_.groups.empty())
    draw_scatter(*plot_, scatter_, theme);
  else if (!histograms_.empty())
    draw_histograms(*plot_, histograms_, theme);
  else if (!curves_.empty())
    draw_curves(*plot_, curves_, theme);
  else
    draw_hint(*plot_, hint_, theme);
  for (QCPAxisRect* rect : plot_->axisRects()) {
    rect->setRangeDrag(Qt::Horizontal);
    rect->setRangeZoom(Qt::Horizontal);
    if (zoomed_) rect->axis(QCPAxis::atBottom)->setRange(before[0], before[1]);
  }
  ring();
  fit_legend();
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void Chart::fit_legend() {
  wrap_legend(*plot_);
  plot_->setMinimumHeight(least_height(*plot_));
}

QWidget* Chart::canvas() const { return plot_; }

bool Chart::zoom_by(int key) {
  if (!may_zoom_ || plot_->axisRectCount() == 0) return false;
  if (key == Qt::Key_Home) {
    show_all();
    return true;
  }
  if (key != Qt::Key_Plus && key != Qt::Key_Minus) return false;
  zoomed_ = true;
  QCPAxis* const x = plot_->axisRects().front()->axis(QCPAxis::atBottom);
  const double factor = key == Qt::Key_Plus ? 1.0 / zoom_factor : zoom_factor;
  if (chosen_)
    x->scaleRange(factor, point_at(*chosen_).x);
  else
    x->scaleRange(factor);
  plot_->replot(QCustomPlot::rpQueuedReplot);
  return true;
}

/// A drag chooses nothing.
bool Chart::release(const QPoint& at) {
  if ((at - pressed_).manhattanLength() > least_drag_px) {
    zoomed_ = zoomed_ || may_zoom_;
  } else if (click(at)) {
    Q_EMIT opened(chosen_->first, chosen_->second);
  }
  return false;
}

bool Chart::eventFilter(QObject* watched, QEvent* event) {
  if (watched != plot_) return QWidget::eventFilter(watched, event);
  if (event->type() == QEvent::Resize) histograms_.empty() ? fit_legend() : redraw();
  if (event->type() == QEvent::KeyPress) return press(static_cast<QKeyEvent*>(event)->key());
  if (event->type() == QEvent::MouseMove) hover(static_cast<QMouseEvent*>(event)->position().toPoint());
  if (event->type() == QEvent::Wheel) zoomed_ = may_zoom_;
  if (event->type() == QEvent::MouseButtonDblClick && may_zoom_) show_all();
  if (event->type() != QEvent::MouseButtonPress && event->type() != QEvent::MouseButtonRelease) return false;
  const auto* mouse = static_cast<QMouseEvent*>(event);
  if (mouse->button() != Qt::LeftButton) return false;
  if (event->type() == QEvent::MouseButtonRelease) return release(mouse->position().toPoint());
  pressed_ = mouse->position().toPoint();
  return false;
}

void Chart::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && plot_ != nullptr) redraw();
}

}  // namespace jointid::gui
