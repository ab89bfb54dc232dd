#include "gui/geometry/structure_view.hpp"

#include <QKeyEvent>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>

#include "gui/geometry/nearest.hpp"
#include "gui/look/named.hpp"

namespace jointid::gui {
namespace {

constexpr double step = 0.12, radians_per_pixel = 0.01, wheel_factor = 1.2;
constexpr double nearest_px = 9.0;

double size_of(const std::array<std::complex<double>, 3>& motion) {
  return std::sqrt(std::norm(motion[0]) + std::norm(motion[1]) + std::norm(motion[2]));
}

double largest(const Shape& shape) {
  double most = 0.0;
  for (const auto& [node, motion] : shape) {
    for (const auto& part : motion) most = std::max(most, std::abs(part));
  }
  return most;
}

double largest_motion(const Shape& shape) {
  double most = 0.0;
  for (const auto& [node, motion] : shape) most = std::max(most, size_of(motion));
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
  largest_ = largest_motion(shape_);
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

void StructureView::set_springs(std::vector<DrawnSpring> springs) {
  springs_ = std::move(springs);
  update();
}

void StructureView::set_own_lines(std::vector<frf::NodeLine> lines) {
  pen_.set_own(std::move(lines));
  update();
}

void StructureView::look(Camera::Side side) {
  camera_.look_from(side);
  update();
}

/// How far a node moves beside the one that moves most, 0 to 1.
double StructureView::share_of(const frf::Node& node) const {
  const auto found = shape_.find(node.id);
  return found == shape_.end() || !(largest_ > 0.0) ? 0.0 : size_of(found->second) / largest_;
}

Vector StructureView::moved(const frf::Node& node) const {
  const auto found = shape_.find(node.id);
  if (found == shape_.end()) return node.position;
  Vector out = node.position;
  const std::complex<double> turn = std::polar(scale_, phase_);
  for (std::size_t i = 0; i < 3; ++i) out[i] += (found->second[i] * turn).real();
  return out;
}

Vector StructureView::drawn_position(std::int64_t node) const {
  const frf::Node& found = structure_.nodes[place_.at(node)];
  return shape_.empty() ? found.position : moved(found);
}

/// Arrows move with their nodes.
QPointF StructureView::tip_of(const frf::Dof& dof) const {
  const frf::Node& node = structure_.nodes[place_.at(dof.node)];
  return camera_.project(plus(drawn_position(dof.node), direction_of(node, dof), camera_.arrow_length()));
}

QPointF StructureView::place_of(std::int64_t node) const { return camera_.project(drawn_position(node)); }

std::optional<frf::Dof> StructureView::dof_at(const QPointF& at) const {
  return nearest(structure_.dofs, nearest_px,
                 [&](const frf::Dof& dof) { return distance_to(at, place_of(dof.node), tip_of(dof)); });
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
  if (drawing_) return click_with_pen(event->position());
  if (const auto dof = dof_at(event->position())) Q_EMIT dof_clicked(*dof);
}

void StructureView::mouseDoubleClickEvent(QMouseEvent* event) {
  turned_ = true;  // its release chooses nothing
  if (!drawing_ && !dof_at(event->position())) show_all();
}

void StructureView::wheelEvent(QWheelEvent* event) {
  zoom(event->angleDelta().y() > 0 ? wheel_factor : 1.0 / wheel_factor);
  event->accept();
}

void StructureView::keyPressEvent(QKeyEvent* event) {
  if (drawing_ && draw_by_key(event->key())) return;
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
    case Qt::Key_F:
      return look(Camera::Side::front);
    case Qt::Key_S:
      return look(Camera::Side::side);
    case Qt::Key_T:
      return look(Camera::Side::top);
    case Qt::Key_L:
      Q_EMIT pen_wanted();
      return;
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace jointid::gui
