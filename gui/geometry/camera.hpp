#pragma once

#include <QPointF>
#include <QSizeF>

#include "gui/geometry/structure.hpp"

namespace jointid::gui {

/// From where a structure is looked at: turned about the z-axis, then about the picture's horizontal axis, without perspective.
class Camera {
 public:
  /// Along y, along −x, along −z: the horizontal axes of the picture are x, y and x.
  enum class Side { front, side, top };

  /// Looks at the whole from the side and a little from above.
  void show_all();
  void look_from(Side side);
  void look_at(const Extent& extent) { extent_ = extent; }
  void set_size(const QSizeF& size) { size_ = size; }
  void turn(double azimuth_rad, double elevation_rad);  ///< from straight below to straight above
  void zoom(double factor);

  QPointF project(const Vector& point) const;
  /// Of an arrow, m: as many pixels however near.
  double arrow_length() const;
  /// Pixels for one radius of the structure.
  double pixels() const;
  const Extent& extent() const { return extent_; }

 private:
  static constexpr double first_azimuth = -0.6, first_elevation = 0.45;

  Extent extent_;
  QSizeF size_{1.0, 1.0};
  double azimuth_ = first_azimuth, elevation_ = first_elevation, zoom_ = 1.0;
};

Vector plus(const Vector& a, const Vector& b, double times);

/// Of a point from a line between two others.
double distance_to(const QPointF& at, const QPointF& from, const QPointF& to);

}  // namespace jointid::gui
