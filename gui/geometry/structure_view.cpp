#include "gui/geometry/structure_view.hpp"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "gui/look/named.hpp"
#include "gui/look/said.hpp"
#include "gui/look/theme.hpp"

namespace jointid::gui {
namespace {

constexpr double step = 0.12, radians_per_pixel = 0.01, wheel_factor = 1.2;
constexpr double nearest_px = 9.0;

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

double largest(const Shape& shape) {
  double most = 0.0;
  for (const auto& [node, motion] : shape) {
    for (const auto& part : motion) most = std::max(most, std::abs(part));
  }
  return most;
}

}  // namespace

StructureView::StructureView(QWidget* parent) : QWidget(parent) {
  named(this, "structure", tr("Structure: nodes, lines and measured DOFs"));
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(240, 200);
}

void StructureView::set_structure(Structure structure) {
  structure_ = std::move(structure);
  camera_.look_at(extent_of(structure_));
  place_.clear();
  for (std::size_t i = 0; i < structure_.nodes.size(); ++i) place_[structure_.nodes[i].id] = i;
  shape_.clear();
  show_all();
}

void StructureView::set_joint(std::vector<frf::Dof> joint) {
  joint_ = std::move(joint);
  update();
}

void StructureView::set_current(const std::optional<frf::Dof>& dof) {
  current_ = dof;
  update();
}

void StructureView::set_shape(Shape shape, double amplitude) {
  shape_ = std::move(shape);
  const double most = largest(shape_);
  scale_ = most > 0.0 ? amplitude * camera_.extent().radius / most : 0.0;
  update();
}

void StructureView::set_phase(double phase_rad) {
  phase_ = phase_rad;
  update();
}

void StructureView::set_undeformed(bool on) {
  undeformed_ = on;
  update();
}

void StructureView::set_names(bool on) {
  names_ = on;
  update();
}

Vector StructureView::moved(const frf::Node& node) const {
  const auto found = shape_.find(node.id);
  if (found == shape_.end()) return node.position;
  Vector out = node.position;
  const std::complex<double> turn = std::polar(scale_, phase_);
  for (std::size_t i = 0; i < 3; ++i) out[i] += (found->second[i] * turn).real();
  return out;
}

Vector StructureView::position_of(std::int64_t node) const { return structure_.nodes[place_.at(node)].position; }

QPointF StructureView::tip_of(const frf::Dof& dof) const {
  return camera_.project(plus(position_of(dof.node), along(dof), camera_.arrow_length()));
}

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

void StructureView::paintEvent(QPaintEvent* event) {
  QWidget::paintEvent(event);
  const Colours use = colours(theme_of(palette()));
  QPainter painter(this);
  painter.fillRect(rect(), use.background);
  painter.setRenderHint(QPainter::Antialiasing);
  if (structure_.nodes.empty()) {
    painter.setPen(use.weak_text);
    painter.drawText(rect().adjusted(20, 20, -20, -20), Qt::AlignCenter | Qt::TextWordWrap,
                     tr("The files of the scene say no positions of nodes (UFF datasets 15 and 2411, node_position in HDF5).\n"
                        "Joint DOFs can be chosen in the list all the same."));
    return;
  }
  painter.setPen(QPen(shape_.empty() ? use.text : use.weak_text, shape_.empty() ? 1.5 : 1.0));
  if (shape_.empty() || undeformed_) draw_lines(painter, false);
  painter.setPen(QPen(curve_colour(theme_of(palette()), 2), 2.0));
  if (!shape_.empty()) draw_lines(painter, true);
  draw_arrows(painter);
  draw_nodes(painter);
  draw_axes(painter);
  if (!hasFocus()) return;
  painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

std::optional<frf::Dof> StructureView::dof_at(const QPointF& at) const {
  double nearest = nearest_px;
  std::optional<frf::Dof> found;
  for (const frf::Dof& dof : structure_.dofs) {
    const double distance = distance_to(at, camera_.project(position_of(dof.node)), tip_of(dof));
    if (distance >= nearest) continue;
    nearest = distance;
    found = dof;
  }
  return found;
}

void StructureView::turn(double azimuth, double elevation) {
  camera_.turn(azimuth, elevation);
  update();
}

void StructureView::zoom(double factor) {
  camera_.zoom(factor);
  update();
}

void StructureView::show_all() {
  camera_.show_all();
  update();
}

void StructureView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  camera_.set_size(size());
}

void StructureView::mousePressEvent(QMouseEvent* event) {
  pressed_ = last_ = event->position();
  turned_ = false;
}

void StructureView::mouseMoveEvent(QMouseEvent* event) {
  if ((event->buttons() & Qt::LeftButton) == 0) return;
  if ((event->position() - pressed_).manhattanLength() > 4.0) turned_ = true;
  if (!turned_) return;
  const QPointF off = event->position() - last_;
  last_ = event->position();
  turn(radians_per_pixel * off.x(), radians_per_pixel * off.y());
}

void StructureView::mouseReleaseEvent(QMouseEvent* event) {
  if (turned_ || event->button() != Qt::LeftButton) return;
  if (const auto dof = dof_at(event->position())) Q_EMIT dof_clicked(*dof);
}

void StructureView::mouseDoubleClickEvent(QMouseEvent* event) {
  turned_ = true;  // its release chooses nothing
  if (!dof_at(event->position())) show_all();
}

void StructureView::wheelEvent(QWheelEvent* event) {
  zoom(event->angleDelta().y() > 0 ? wheel_factor : 1.0 / wheel_factor);
  event->accept();
}

void StructureView::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Left:
      return turn(-step, 0.0);
    case Qt::Key_Right:
      return turn(step, 0.0);
    case Qt::Key_Up:
      return turn(0.0, -step);
    case Qt::Key_Down:
      return turn(0.0, step);
    case Qt::Key_Plus:
      return zoom(wheel_factor);
    case Qt::Key_Minus:
      return zoom(1.0 / wheel_factor);
    case Qt::Key_Home:
      return show_all();
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace jointid::gui
