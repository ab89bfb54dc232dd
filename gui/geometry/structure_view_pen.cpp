#include <QPainter>
#include <cmath>

#include "gui/geometry/nearest.hpp"
#include "gui/geometry/structure_view.hpp"
#include "gui/look/theme.hpp"

/// Lines drawn by hand.
namespace jointid::gui {
namespace {

constexpr double node_reach_px = 12.0, line_reach_px = 6.0;

}  // namespace

void StructureView::set_drawing(bool on) {
  drawing_ = on;
  pen_.lift();
  update();
  Q_EMIT drawing_changed();
}

std::optional<std::int64_t> StructureView::node_at(const QPointF& at) const {
  const auto found = nearest(structure_.nodes, node_reach_px, [&](const frf::Node& node) {
    const QPointF off = place_of(node.id) - at;
    return std::hypot(off.x(), off.y());
  });
  return found ? std::optional(found->id) : std::nullopt;
}

std::vector<frf::NodeLine> StructureView::drawn_own_lines() const {
  std::vector<frf::NodeLine> lines = own_lines();
  std::erase_if(lines, [&](const frf::NodeLine& line) { return !is_drawn(line); });
  return lines;
}

/// Of the files and by hand, between nodes that are there.
std::vector<frf::NodeLine> StructureView::all_lines() const {
  std::vector<frf::NodeLine> lines = structure_.lines;
  const std::vector<frf::NodeLine> own = drawn_own_lines();
  lines.insert(lines.end(), own.begin(), own.end());
  return lines;
}

std::optional<frf::NodeLine> StructureView::own_line_at(const QPointF& at) const {
  return nearest(drawn_own_lines(), line_reach_px,
                 [&](const frf::NodeLine& line) { return distance_to(at, place_of(line[0]), place_of(line[1])); });
}

void StructureView::pick(std::int64_t node) {
  if (pen_.pick(node, structure_.lines)) Q_EMIT own_lines_changed();
}

/// Nodes before lines, which end there.
void StructureView::click_with_pen(const QPointF& at) {
  if (const auto node = node_at(at))
    pick(*node);
  else if (const auto line = own_line_at(at))
    pen_.choose(*line);
  else
    pen_.lift();
  update();
  Q_EMIT drawing_changed();
}

/// False for keys that are not the pen's.
bool StructureView::draw_by_key(int key) {
  std::vector<std::int64_t> nodes;
  for (const frf::Node& node : structure_.nodes) nodes.push_back(node.id);
  switch (key) {
    case Qt::Key_PageDown:
    case Qt::Key_PageUp:
      pen_.step(nodes, key == Qt::Key_PageDown ? 1 : -1);
      break;
    case Qt::Key_Space:
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (pen_.at() && place_.contains(*pen_.at())) pick(*pen_.at());
      break;
    case Qt::Key_Delete:
      if (pen_.remove()) Q_EMIT own_lines_changed();
      break;
    case Qt::Key_Escape:
      pen_.lift();
      break;
    default:
      return false;
  }
  update();
  Q_EMIT drawing_changed();
  return true;
}

/// The chosen line broad, a ring round the node that is picked, a square where the keys are.
void StructureView::draw_pen(QPainter& painter) const {
  constexpr double ring_px = 8.0;
  const QColor colour = palette().color(QPalette::Highlight);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colour, 4.0));
  if (pen_.chosen() && is_drawn(*pen_.chosen())) painter.drawLine(place_of((*pen_.chosen())[0]), place_of((*pen_.chosen())[1]));
  painter.setPen(QPen(colour, 2.0));
  if (pen_.from() && place_.contains(*pen_.from())) painter.drawEllipse(place_of(*pen_.from()), ring_px, ring_px);
  if (!pen_.at() || !place_.contains(*pen_.at())) return;
  const QPointF corner(ring_px, ring_px), at = place_of(*pen_.at());
  painter.drawRect(QRectF(at - corner, at + corner));
}

}  // namespace jointid::gui
