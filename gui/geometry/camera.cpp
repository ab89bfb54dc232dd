#include "gui/geometry/camera.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace jointid::gui {
namespace {

constexpr double arrow_share = 0.13;  // of the structure's radius
constexpr double room = 0.85;         // of the picture that the structure fills

}  // namespace

void Camera::show_all() {
  azimuth_ = first_azimuth;
  elevation_ = first_elevation;
  zoom_ = 1.0;
}

void Camera::look_from(Side side) {
  azimuth_ = side == Side::side ? -std::numbers::pi / 2.0 : 0.0;
  elevation_ = side == Side::top ? std::numbers::pi / 2.0 : 0.0;
}

void Camera::turn(double azimuth_rad, double elevation_rad) {
  azimuth_ += azimuth_rad;
  elevation_ = std::clamp(elevation_ + elevation_rad, -std::numbers::pi / 2.0, std::numbers::pi / 2.0);
}

void Camera::zoom(double factor) { zoom_ = std::clamp(zoom_ * factor, 0.2, 50.0); }

double Camera::pixels() const { return room * zoom_ * std::min(size_.width(), 2.0 * size_.height()) / 2.0; }

double Camera::arrow_length() const { return arrow_share * extent_.radius / zoom_; }

QPointF Camera::project(const Vector& point) const {
  const Vector off = plus(point, extent_.middle, -1.0);
  const double right = off[0] * std::cos(azimuth_) - off[1] * std::sin(azimuth_);
  const double deep = off[0] * std::sin(azimuth_) + off[1] * std::cos(azimuth_);
  const double up = off[2] * std::cos(elevation_) + deep * std::sin(elevation_);
  const double scale = pixels() / extent_.radius;
  return {size_.width() / 2.0 + scale * right, size_.height() / 2.0 - scale * up};
}

Vector plus(const Vector& a, const Vector& b, double times) {
  return {a[0] + times * b[0], a[1] + times * b[1], a[2] + times * b[2]};
}

double distance_to(const QPointF& at, const QPointF& from, const QPointF& to) {
  const QPointF all = to - from, own = at - from;
  const double square = QPointF::dotProduct(all, all);
  const double share = square > 0.0 ? std::clamp(QPointF::dotProduct(own, all) / square, 0.0, 1.0) : 0.0;
  const QPointF off = own - share * all;
  return std::hypot(off.x(), off.y());
}

}  // namespace jointid::gui
