#include <QPainter>
#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "gui/geometry/structure_view.hpp"
#include "gui/look/said.hpp"
#include "gui/look/theme.hpp"
#include "gui/plot/picture.hpp"

namespace jointid::gui {
namespace {

/// Rotations have two heads.
void draw_arrow(QPainter& painter, const QPointF& from, const QPointF& to, bool is_rotation) {
  painter.drawLine(from, to);
  const QPointF all = to - from;
  const double size = std::hypot(all.x(), all.y());
  if (!(size > 2.0)) return;
  const QPointF unit = all / size, side(-unit.y(), unit.x());
  for (int head = 0; head < (is_rotation ? 2 : 1); ++head) {
    const QPointF tip = to - 5.0 * head * unit;
    for (const double sign : {-1.0, 1.0}) painter.drawLine(tip, tip - 6.0 * unit + 3.0 * sign * side);
  }
}

}  // namespace

void StructureView::draw_lines(QPainter& painter, bool deflected) const {
  for (const frf::NodeLine& line : structure_.lines) {
    const frf::Node &from = structure_.nodes[place_.at(line[0])], &to = structure_.nodes[place_.at(line[1])];
    painter.drawLine(camera_.project(deflected ? moved(from) : from.position),
                     camera_.project(deflected ? moved(to) : to.position));
  }
}

void StructureView::draw_nodes(QPainter& painter) const {
  const Colours use = colours(theme_of(palette()));
  const auto in_joint = [this](const frf::Node& node) {
    return std::ranges::find(joint_, node.id, &frf::Dof::node) != joint_.end();
  };
  for (const frf::Node& node : structure_.nodes) {
    const QPointF at = camera_.project(shape_.empty() ? node.position : moved(node));
    painter.setPen(Qt::NoPen);
    painter.setBrush(in_joint(node) ? use.error : use.text);
    painter.drawEllipse(at, in_joint(node) ? 4.0 : 2.5, in_joint(node) ? 4.0 : 2.5);
    if (!names_) continue;
    painter.setPen(use.weak_text);
    painter.drawText(camera_.project(node.position) + QPointF(5.0, 14.0), QString::number(node.id));
  }
}

void StructureView::draw_arrows(QPainter& painter) const {
  const Colours use = colours(theme_of(palette()));
  painter.setBrush(Qt::NoBrush);
  for (const frf::Dof& dof : structure_.dofs) {
    const bool is_joint = frf::has(joint_, dof), is_current = current_ && current_->same_coordinate(dof);
    painter.setPen(QPen(is_joint ? use.error : curve_colour(theme_of(palette()), 0), is_current ? 3.0 : is_joint ? 2.0 : 1.0));
    draw_arrow(painter, camera_.project(position_of(dof.node)), tip_of(dof), dof.is_rotation());
    if (!is_current) continue;
    painter.setPen(use.text);
    painter.drawText(tip_of(dof) + QPointF(6.0, -4.0), q(dof.name()));
  }
}

/// Where x, y and z are, in the lower left corner.
void StructureView::draw_axes(QPainter& painter) const {
  constexpr double size = 28.0;
  const QPointF corner(44.0, height() - 40.0), zero = camera_.project(camera_.extent().middle);
  painter.setPen(colours(theme_of(palette())).weak_text);
  for (std::size_t i = 0; i < 3; ++i) {
    Vector end = camera_.extent().middle;
    end[i] += camera_.extent().radius;
    const QPointF tip = corner + (camera_.project(end) - zero) * (size / camera_.pixels());
    painter.drawLine(corner, tip);
    painter.drawText(tip + QPointF(3.0, 3.0), QString(QChar('x' + static_cast<int>(i))));
  }
}

void StructureView::paint(QPainter& painter) const {
  const Colours use = colours(theme_of(palette()));
  painter.fillRect(rect(), use.background);
  painter.setRenderHint(QPainter::Antialiasing);
  if (structure_.nodes.empty()) {
    painter.setPen(use.weak_text);
    painter.drawText(rect().adjusted(20, 20, -20, -20), Qt::AlignCenter | Qt::TextWordWrap,
                     tr("The files of the scene have no positions of nodes (UFF datasets 15 and 2411, node_position in "
                        "HDF5).\nYou can choose joint DOFs in the list."));
    return;
  }
  painter.setPen(QPen(shape_.empty() ? use.text : use.weak_text, shape_.empty() ? 1.5 : 1.0));
  if (shape_.empty() || undeformed_) draw_lines(painter, false);
  painter.setPen(QPen(curve_colour(theme_of(palette()), 2), 2.0));
  if (!shape_.empty()) draw_lines(painter, true);
  draw_arrows(painter);
  draw_nodes(painter);
  draw_axes(painter);
}

void StructureView::paintEvent(QPaintEvent* event) {
  QWidget::paintEvent(event);
  QPainter painter(this);
  paint(painter);
  if (structure_.nodes.empty() || !hasFocus()) return;
  painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

QByteArray StructureView::picture(const QString& ending) const {
  return picture_of(
      size(), [this](QPainter& painter) { paint(painter); }, ending);
}

std::string StructureView::table(char separator) const {
  const std::string then(1, separator);
  std::string out = "node" + then + "x (m)" + then + "y (m)" + then + "z (m)";
  for (const char* axis : {"x", "y", "z"}) {
    if (!shape_.empty()) out += then + "shape " + axis + ", real" + then + "shape " + axis + ", imaginary";
  }
  for (const frf::Node& node : structure_.nodes) {
    out += "\n" + std::to_string(node.id);
    for (const double coordinate : node.position) out += then + digits(coordinate, "%.17g");
    const auto found = shape_.find(node.id);
    for (std::size_t axis = 0; axis < 3 && !shape_.empty(); ++axis) {
      const auto value = found == shape_.end() ? std::complex<double>() : found->second[axis];
      out += then + digits(value.real(), "%.17g") + then + digits(value.imag(), "%.17g");
    }
  }
  return out + "\n";
}

}  // namespace jointid::gui
