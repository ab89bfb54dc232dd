#include "gui/geometry/mode_shapes.hpp"

#include <cmath>
#include <numbers>
#include <set>

#include "base/text.hpp"
#include "gui/look/said.hpp"

namespace jointid::gui {
namespace {

std::complex<double>& component(Shape& shape, const frf::Dof& dof) {
  return shape[dof.node][static_cast<std::size_t>(dof.direction) - 1];
}

}  // namespace

std::vector<NamedShape> named_shapes(const std::vector<frf::Uff55Mode>& modes, const QString& from) {
  std::vector<NamedShape> out;
  for (const frf::Uff55Mode& mode : modes) {
    NamedShape each{QStringLiteral("%1: %2 Hz, %3").arg(mode.number).arg(mode.frequency_hz, 0, 'g', 5).arg(from), {}};
    for (std::size_t i = 0; i < mode.dofs.size(); ++i) {
      const frf::Dof& dof = mode.dofs[i];
      if (!dof.is_rotation()) component(each.shape, dof) = static_cast<double>(dof.sign) * mode.shape[i];
    }
    out.push_back(std::move(each));
  }
  return out;
}

Shape joint_deflection(const Shape& shape, const std::vector<frf::Dof>& joint) {
  Shape out;
  for (const frf::Dof& dof : joint) {
    if (const auto found = shape.find(dof.node); found != shape.end()) out.insert(*found);
  }
  if (out.size() < 2) return shape;
  std::array<std::complex<double>, 3> mean{};
  for (const auto& [node, motion] : out) {
    for (std::size_t i = 0; i < 3; ++i) mean[i] += motion[i] / static_cast<double>(out.size());
  }
  for (auto& [node, motion] : out) {
    for (std::size_t i = 0; i < 3; ++i) motion[i] -= mean[i];
  }
  return out;
}

QString joint_motion_text(const Shape& shape, const std::vector<frf::Dof>& joint) {
  QStringList parts;
  for (const frf::Dof& dof : joint) {
    const auto found = shape.find(dof.node);
    if (found == shape.end() || dof.is_rotation()) continue;
    const std::complex<double> value = static_cast<double>(dof.sign) * found->second[static_cast<std::size_t>(dof.direction) - 1];
    parts << q(dof.name() + " " + digits(std::abs(value), "%.3g") + " ∠ " +
               digits(std::atan2(value.imag() + 0.0, value.real()) * 180.0 / std::numbers::pi, "%.0f") + "°");
  }
  return parts.join(QStringLiteral(", "));
}

}  // namespace jointid::gui
