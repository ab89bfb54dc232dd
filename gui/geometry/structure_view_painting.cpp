#include <QImage>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/text.hpp"
#include "gui/geometry/structure_view.hpp"
#include "gui/look/said.hpp"
#include "gui/look/theme.hpp"
#include "gui/plot/animated_gif.hpp"
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

/// Of a node by its motion: grey at rest, over blue and yellow to red where it moves most.
QColor motion_colour(Theme theme, double share) {
  const double hue = 220.0 * (1.0 - share);  // degrees
  const double depth = std::min(1.0, 0.25 + share);
  return QColor::fromHsvF(static_cast<float>(hue / 360.0), static_cast<float>(depth), theme == Theme::dark ? 0.95F : 0.80F);
}

QColor tightness_colour(tasks::Tightness tightness, const Colours& use) {
  switch (tightness) {
    case tasks::Tightness::alike: return use.good;
    case tasks::Tightness::doubtful: return use.warning;
    case tasks::Tightness::loose: break;
  }
  return use.error;
}

}  // namespace

/// A loose spring is thin and red, one like the others broad and green.
void StructureView::draw_springs(QPainter& painter) const {
  constexpr double thinnest = 2.5, broadest = 8.0, nearest_px = 14.0;
  const Colours use = colours(theme_of(palette()));
  for (const DrawnSpring& spring : springs_) {
    if (!place_.contains(spring.first) || !place_.contains(spring.second)) continue;
    const QPointF from = camera_.project(drawn_position(spring.first)), to = camera_.project(drawn_position(spring.second));
    const QPointF middle = (from + to) / 2.0;
    const QColor colour = tightness_colour(spring.tightness, use);
    const double width = thinnest + (broadest - thinnest) * std::clamp(spring.share, 0.0, 1.0);
    painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap));
    painter.setBrush(Qt::NoBrush);
    if (std::hypot(to.x() - from.x(), to.y() - from.y()) < nearest_px)
      painter.drawEllipse(middle, 9.0, 9.0);
    else
      painter.drawLine(from, to);
    if (spring.label.isEmpty()) continue;
    painter.setPen(colour);
    painter.drawText(middle + QPointF(13.0, -8.0), spring.label);
  }
}

/// What the colours of a motion mean.
void StructureView::draw_scale(QPainter& painter) const {
  constexpr int steps = 40, step_px = 3, height_px = 8;
  const QPointF corner(width() - steps * step_px - 14.0, height() - 30.0);
  for (int i = 0; i < steps; ++i) {
    const QRectF step(corner.x() + i * step_px, corner.y(), step_px, height_px);
    painter.fillRect(step, motion_colour(theme_of(palette()), (i + 0.5) / steps));
  }
  painter.setPen(colours(theme_of(palette())).weak_text);
  painter.drawText(corner + QPointF(0.0, 20.0), tr("at rest"));
  painter.drawText(QRectF(corner.x(), corner.y() + 8.0, steps * step_px, 16.0), Qt::AlignRight, tr("most"));
}

void StructureView::draw_lines(QPainter& painter, bool deflected) const {
  for (const frf::NodeLine& line : all_lines()) {
    const frf::Node &from = structure_.nodes[place_.at(line[0])], &to = structure_.nodes[place_.at(line[1])];
    if (!deflected && shape_.empty()) painter.setPen(QPen(part_colour(from), 1.5));
    if (deflected) painter.setPen(QPen(motion_colour(theme_of(palette()), (share_of(from) + share_of(to)) / 2.0), 2.5));
    painter.drawLine(camera_.project(deflected ? moved(from) : from.position),
                     camera_.project(deflected ? moved(to) : to.position));
  }
}

QColor StructureView::part_colour(const frf::Node& node) const {
  const auto found = structure_.part.find(node.id);
  const bool several = std::ranges::any_of(structure_.part, [](const auto& each) { return each.second > 0; });
  return found == structure_.part.end() || !several ? colours(theme_of(palette())).text
                                                    : curve_colour(theme_of(palette()), found->second);
}

std::vector<std::pair<std::int64_t, QRectF>> StructureView::name_places() const {
  const QFontMetricsF metrics(font());
  std::vector<std::pair<std::int64_t, QRectF>> out;
  const auto is_free = [&out](const QRectF& place) {
    return std::ranges::none_of(out, [&](const auto& each) { return each.second.intersects(place); });
  };
  const auto in_joint = [this](const frf::Node& node) {
    return std::ranges::find(joint_, node.id, &frf::Dof::node) != joint_.end();
  };
  for (const bool of_joint : {true, false}) {
    for (const frf::Node& node : structure_.nodes) {
      if (in_joint(node) != of_joint) continue;
      const QSizeF size = metrics.size(0, QString::number(node.id));
      const QPointF at = camera_.project(node.position);
      QRectF place(at + QPointF(5.0, 2.0), size);
      const QPointF left(-size.width() - 10.0, 0.0), up(0.0, -size.height() - 4.0);
      const QRectF first = place;
      for (const QPointF& by : {left, up, left + up}) {
        if (!is_free(place)) place = first.translated(by);
      }
      while (of_joint && !is_free(place)) place.translate(0.0, size.height());
      if (is_free(place)) out.emplace_back(node.id, place);
    }
  }
  return out;
}

void StructureView::draw_nodes(QPainter& painter) const {
  const Colours use = colours(theme_of(palette()));
  const auto in_joint = [this](const frf::Node& node) {
    return std::ranges::find(joint_, node.id, &frf::Dof::node) != joint_.end();
  };
  for (const frf::Node& node : structure_.nodes) {
    const QPointF at = camera_.project(shape_.empty() ? node.position : moved(node));
    painter.setPen(Qt::NoPen);
    painter.setBrush(in_joint(node)   ? use.error
                     : shape_.empty() ? part_colour(node)
                                      : motion_colour(theme_of(palette()), share_of(node)));
    painter.drawEllipse(at, in_joint(node) ? 4.0 : 2.5, in_joint(node) ? 4.0 : 2.5);
  }
  if (!names_) return;
  painter.setPen(use.weak_text);
  for (const auto& [node, place] : name_places()) painter.drawText(place, Qt::AlignCenter, QString::number(node));
}

void StructureView::draw_arrows(QPainter& painter) const {
  const Colours use = colours(theme_of(palette()));
  painter.setBrush(Qt::NoBrush);
  for (const frf::Dof& dof : structure_.dofs) {
    const bool is_joint = frf::has(joint_, dof), is_current = current_ && current_->same_coordinate(dof);
    painter.setPen(QPen(is_joint ? use.error : curve_colour(theme_of(palette()), 0), is_current ? 3.0 : is_joint ? 2.0 : 1.0));
    draw_arrow(painter, camera_.project(drawn_position(dof.node)), tip_of(dof), dof.is_rotation());
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
  if (!shape_.empty()) draw_lines(painter, true);
  draw_springs(painter);
  draw_arrows(painter);
  draw_nodes(painter);
  if (drawing_) draw_pen(painter);
  if (!shape_.empty()) draw_scale(painter);
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

QByteArray StructureView::film() {
  constexpr int pictures = 36, milliseconds = 40;
  const double before = phase_;
  std::vector<QImage> all;
  for (int i = 0; i < pictures; ++i) {
    phase_ = 2.0 * std::numbers::pi * i / pictures;
    QImage image(size(), QImage::Format_RGB32);
    image.fill(colours(theme_of(palette())).background);
    QPainter painter(&image);
    paint(painter);
    painter.end();
    all.push_back(std::move(image));
  }
  phase_ = before;
  return animated_gif(all, milliseconds);
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
