#include "gui/plot/heat_chart.hpp"

#include <qcustomplot.h>

#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/text.hpp"
#include "gui/look/named.hpp"
#include "gui/look/said.hpp"
#include "gui/look/theme.hpp"
#include "gui/plot/panel_drawing.hpp"
#include "gui/plot/quoted.hpp"
#include "gui/plot/saving_row.hpp"

namespace jointid::gui {
namespace {

constexpr int cells_along_x = 600;  // of an axis of numbers, evenly
constexpr int least_side_px = 200;
constexpr std::size_t most_names = 40;  // of an axis; of more, every second, third …

/// The place of the value nearest to `x`.
std::size_t nearest_place(const std::vector<double>& values, double x) {
  const auto above = std::ranges::lower_bound(values, x);
  if (above == values.begin()) return 0;
  const auto place = static_cast<std::size_t>(above - values.begin());
  return above == values.end() || x - values[place - 1] < *above - x ? place - 1 : place;
}

void name_ticks(QCPAxis& axis, const std::vector<std::string>& names) {
  const auto ticker = QSharedPointer<QCPAxisTickerText>::create();
  const std::size_t step = 1 + names.size() / most_names;
  for (std::size_t i = 0; i < names.size(); i += step) ticker->addTick(static_cast<double>(i), q(names[i]));
  axis.setTicker(ticker);
  axis.setSubTicks(false);
}

QCPColorGradient gradient_of(Theme theme) {
  QCPColorGradient out;
  out.clearColorStops();
  for (const double stop : {0.0, 0.25, 0.5, 0.75, 1.0}) out.setColorStopAt(stop, shade(theme, stop));
  out.setNanHandling(QCPColorGradient::nhTransparent);
  return out;
}

/// The map's; the scale beside it has another. Null where there is none.
QCPAxisRect* map_rect(const QCustomPlot& plot) {
  return plot.plotLayout()->elementCount() == 0 ? nullptr : qobject_cast<QCPAxisRect*>(plot.plotLayout()->elementAt(0));
}

}  // namespace

HeatPlot heat_of(const report::CurvePlot& plot, const std::string& rows) {
  HeatPlot out{.x_label = plot.x.label,
               .y_label = rows,
               .value_label = plot.y.label,
               .columns = {},
               .x_values = plot.x_values,
               .rows = {},
               .values = {},
               .log = plot.y.log};
  for (const report::Series& series : plot.series) {
    if (series.y.size() != plot.x_values.size()) continue;
    out.rows.push_back(series.name);
    out.values.insert(out.values.end(), series.y.begin(), series.y.end());
  }
  return out;
}

HeatChart::HeatChart(const char* name, const QString& accessible_name, const QString& hint, QWidget* parent)
    : QWidget(parent), hint_(hint), plot_(new QCustomPlot(this)) {
  setAccessibleName(accessible_name);
  named(plot_, name, accessible_name);
  plot_->setFocusPolicy(Qt::StrongFocus);
  plot_->setMinimumSize(least_side_px, least_side_px);
  speak_numbers(*plot_);
  plot_->setMouseTracking(true);
  plot_->installEventFilter(this);
  readout_ = named(new QLabel, "heat_readout", tr("The value under the mouse"));
  readout_->setTextFormat(Qt::PlainText);
  readout_->setWordWrap(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(plot_, 1);
  add_saving_row(
      *column, readout_, "heat", [this] { copy_plot(saveable()); },
      [this] { ask_and_save(this, saveable(), inputs_, plot_->objectName() + QStringLiteral(".png")); });
  redraw();
}

void HeatChart::draw(HeatPlot plot) {
  heat_ = std::move(plot);
  row_ = column_ = 0;
  readout_->clear();
  redraw();
}

QString HeatChart::readout() const { return readout_->text(); }

QWidget* HeatChart::canvas() const { return plot_; }

std::size_t HeatChart::column_count() const { return heat_.columns.empty() ? heat_.x_values.size() : heat_.columns.size(); }

/// An axis of numbers is filled evenly by the nearest columns.
void HeatChart::fill(QCPColorMap& map) const {
  const std::size_t columns = column_count(), rows = heat_.rows.size();
  const bool along = heat_.columns.empty();
  const int cells = along ? cells_along_x : static_cast<int>(columns);
  map.data()->setSize(cells, static_cast<int>(rows));
  map.data()->setRange(
      along ? QCPRange(heat_.x_values.front(), heat_.x_values.back()) : QCPRange(0.0, static_cast<double>(columns - 1)),
      QCPRange(0.0, static_cast<double>(rows) - 1.0));
  double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
  for (int cell = 0; cell < cells; ++cell) {
    double x = 0.0, y = 0.0;
    map.data()->cellToCoord(cell, 0, &x, &y);
    const std::size_t column = along ? nearest_place(heat_.x_values, x) : static_cast<std::size_t>(cell);
    for (std::size_t row = 0; row < rows; ++row) {
      double value = heat_.values[row * columns + column];
      if (heat_.log) value = value > 0.0 ? std::log10(value) : std::nan("");
      map.data()->setCell(cell, static_cast<int>(row), value);
      if (!std::isfinite(value)) continue;
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  if (heat_.from_0_to_1) return map.setDataRange(QCPRange(0.0, 1.0));
  if (high >= low) map.setDataRange(high > low ? QCPRange(low, high) : QCPRange(low - 0.5, low + 0.5));
}

void HeatChart::redraw() {
  plot_->clearItems();
  plot_->clearPlottables();
  plot_->plotLayout()->clear();
  plot_->legend = nullptr;
  const Theme theme = theme_of(palette());
  plot_->setBackground(colours(theme).background);
  if (heat_.values.empty() || column_count() == 0) {
    draw_hint(*plot_, hint_, theme);
    return plot_->replot(QCustomPlot::rpQueuedReplot);
  }
  auto* const rect = new QCPAxisRect(plot_);
  plot_->plotLayout()->addElement(0, 0, rect);
  style_axes(*rect, theme);
  QCPAxis* const x = rect->axis(QCPAxis::atBottom);
  QCPAxis* const y = rect->axis(QCPAxis::atLeft);
  auto* const map = new QCPColorMap(x, y);
  map->setInterpolate(false);
  map->setTightBoundary(false);
  map->setGradient(gradient_of(theme));
  fill(*map);
  x->setLabel(axis_text(heat_.x_label));
  y->setLabel(axis_text(heat_.y_label));
  if (!heat_.columns.empty()) name_ticks(*x, heat_.columns);
  name_ticks(*y, heat_.rows);
  auto* const scale = new QCPColorScale(plot_);
  plot_->plotLayout()->addElement(0, 1, scale);
  scale->setType(QCPAxis::atRight);
  const QCPRange values = map->dataRange();
  map->setColorScale(scale);  // and takes range and colours of the scale
  scale->setGradient(gradient_of(theme));
  scale->setDataRange(values);
  scale->axis()->setLabel(heat_.log ? tr("log10 of %1").arg(axis_text(heat_.value_label)) : axis_text(heat_.value_label));
  tell_ticks_apart(*scale->axis());
  scale->axis()->setTickLabelColor(colours(theme).text);
  scale->axis()->setLabelColor(colours(theme).text);
  // A cell reaches half its width beyond its place.
  const double half = heat_.columns.empty() ? 0.0 : 0.5,
               last = heat_.columns.empty() ? heat_.x_values.back() : static_cast<double>(column_count()) - 1.0;
  x->setRange((heat_.columns.empty() ? heat_.x_values.front() : 0.0) - half, last + half);
  y->setRange(-0.5, static_cast<double>(heat_.rows.size()) - 0.5);
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void HeatChart::show_cell(std::size_t row, std::size_t column) {
  row_ = row;
  column_ = column;
  const double value = heat_.values[row * column_count() + column];
  const QString at = heat_.columns.empty()
                         ? QStringLiteral("%1 %2").arg(axis_text(heat_.x_label)).arg(heat_.x_values[column], 0, 'g', 5)
                         : q(heat_.columns[column]);
  readout_->setText(QStringLiteral("%1 / %2: %3 %4")
                        .arg(q(heat_.rows[row]), at, axis_text(heat_.value_label),
                             std::isfinite(value) ? q(digits(value, "%.4g")) : QStringLiteral("–")));
}

void HeatChart::point_at(const QPoint& pixel) {
  const QCPAxisRect* const rect = map_rect(*plot_);
  if (heat_.values.empty() || rect == nullptr || !rect->rect().contains(pixel)) return;
  const double x = rect->axis(QCPAxis::atBottom)->pixelToCoord(pixel.x()),
               y = rect->axis(QCPAxis::atLeft)->pixelToCoord(pixel.y());
  const auto place = [](double at, std::size_t count) {
    return static_cast<std::size_t>(std::clamp(std::round(at), 0.0, static_cast<double>(count - 1)));
  };
  show_cell(place(y, heat_.rows.size()),
            heat_.columns.empty() ? nearest_place(heat_.x_values, x) : place(x, heat_.columns.size()));
}

QPoint HeatChart::pixel_of(std::size_t row, std::size_t column) const {
  const QCPAxisRect* const rect = map_rect(*plot_);
  const double x = heat_.columns.empty() ? heat_.x_values[column] : static_cast<double>(column);
  return {static_cast<int>(rect->axis(QCPAxis::atBottom)->coordToPixel(x)),
          static_cast<int>(rect->axis(QCPAxis::atLeft)->coordToPixel(static_cast<double>(row)))};
}

bool HeatChart::move_by(int key) {
  if (heat_.values.empty()) return false;
  const std::size_t last_row = heat_.rows.size() - 1, last_column = column_count() - 1;
  if (key == Qt::Key_Left) {
    show_cell(row_, column_ > 0 ? column_ - 1 : 0);
  } else if (key == Qt::Key_Right) {
    show_cell(row_, std::min(column_ + 1, last_column));
  } else if (key == Qt::Key_Up) {
    show_cell(std::min(row_ + 1, last_row), column_);
  } else if (key == Qt::Key_Down) {
    show_cell(row_ > 0 ? row_ - 1 : 0, column_);
  } else {
    return false;
  }
  return true;
}

bool HeatChart::eventFilter(QObject* watched, QEvent* event) {
  if (watched == plot_ && event->type() == QEvent::MouseMove) point_at(static_cast<QMouseEvent*>(event)->position().toPoint());
  if (watched == plot_ && event->type() == QEvent::KeyPress && move_by(static_cast<QKeyEvent*>(event)->key())) return true;
  return QWidget::eventFilter(watched, event);
}

void HeatChart::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && plot_ != nullptr) redraw();
}

/// A line for each row, with the columns as titles.
std::string HeatChart::table(char separator) const {
  const std::size_t columns = column_count();
  std::string out = quoted(heat_.y_label);
  for (std::size_t c = 0; c < columns; ++c)
    out += separator + (heat_.columns.empty() ? digits(heat_.x_values[c], "%.17g") : quoted(heat_.columns[c]));
  out += '\n';
  for (std::size_t r = 0; r < heat_.rows.size(); ++r) {
    out += quoted(heat_.rows[r]);
    for (std::size_t c = 0; c < columns; ++c) out += separator + digits(heat_.values[r * columns + c], "%.17g");
    out += '\n';
  }
  return out;
}

Saveable HeatChart::saveable() const {
  return {[this](const QString& ending) { return picture_of(*plot_, ending); },
          [this](char separator) { return table(separator); }};
}

}  // namespace jointid::gui
