#include <qcustomplot.h>

#include <QLabel>
#include <algorithm>
#include <cmath>

#include "gui/plot/chart.hpp"
#include "gui/plot/chart_drawing.hpp"
#include "gui/plot/panel_drawing.hpp"

/// Points chosen by mouse and keys.
namespace jointid::gui {
namespace {

constexpr double nearest_px = 14.0;

}  // namespace

void Chart::ring() {
  if (!chosen_) return;
  draw_ring(*plot_, point_at(*chosen_), theme_of(palette()));
  readout_->setText(point_text(*chosen_));
}

QString Chart::point_text(const Place& place) const {
  const report::Point& point = point_at(place);
  return QStringLiteral("%1: %2 %3, %4 %5")
      .arg(QString::fromStdString(point.label), axis_text(scatter_.x.label))
      .arg(point.x, 0, 'g', 4)
      .arg(axis_text(scatter_.y.label))
      .arg(point.y, 0, 'g', 4);
}

/// What is chosen comes back where the mouse is over no point.
void Chart::hover(const QPoint& at) {
  if (scatter_.groups.empty()) return;
  const std::optional<Place> over = nearest(at);
  if (over)
    readout_->setText(point_text(*over));
  else if (chosen_)
    readout_->setText(point_text(*chosen_));
  else
    readout_->clear();
}

void Chart::choose(std::size_t group, std::size_t point) {
  chosen_ = Place{group, point};
  ring();
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

QString Chart::readout() const { return readout_->text(); }

QPoint Chart::pixel_of(std::size_t group, std::size_t point) const {
  const report::Point& at = point_at({group, point});
  const QCPAxisRect* const rect = plot_->axisRects().front();
  return {static_cast<int>(rect->axis(QCPAxis::atBottom)->coordToPixel(at.x)),
          static_cast<int>(rect->axis(QCPAxis::atLeft)->coordToPixel(at.y))};
}

const report::Point& Chart::point_at(const Place& place) const { return scatter_.groups[place.first].points[place.second]; }

/// From left to right.
std::vector<Chart::Place> Chart::places() const {
  std::vector<Place> all;
  for (std::size_t g = 0; g < scatter_.groups.size(); ++g) {
    for (std::size_t p = 0; p < scatter_.groups[g].points.size(); ++p) all.emplace_back(g, p);
  }
  std::ranges::stable_sort(all, {}, [this](const Place& place) { return point_at(place).x; });
  return all;
}

std::optional<Chart::Place> Chart::nearest(const QPoint& at) const {
  double least = nearest_px;
  std::optional<Place> found;
  for (const Place& place : places()) {
    const QPoint off = pixel_of(place.first, place.second) - at;
    const double distance = std::hypot(off.x(), off.y());
    if (distance > least) continue;
    least = distance;
    found = place;
  }
  return found;
}

bool Chart::click(const QPoint& at) {
  const std::optional<Place> found = nearest(at);
  if (!found) return false;
  choose(found->first, found->second);
  Q_EMIT chosen(found->first, found->second);
  return true;
}

bool Chart::press(int key) {
  if (zoom_by(key)) return true;
  const std::vector<Place> all = places();
  if (all.empty()) return false;
  const bool enter = key == Qt::Key_Return || key == Qt::Key_Enter;
  if (enter && chosen_) {
    Q_EMIT opened(chosen_->first, chosen_->second);
    return true;
  }
  if (key != Qt::Key_Left && key != Qt::Key_Right) return false;
  const auto now = chosen_ ? std::ranges::find(all, *chosen_) - all.begin() : (key == Qt::Key_Right ? -1 : 1);
  const auto last = static_cast<std::ptrdiff_t>(all.size()) - 1;
  const Place next = all[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(now + (key == Qt::Key_Right ? 1 : -1), 0, last))];
  choose(next.first, next.second);
  Q_EMIT chosen(next.first, next.second);
  return true;
}

}  // namespace jointid::gui
