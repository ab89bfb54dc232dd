#pragma once

#include <QString>
#include <vector>

#include "frf/uff/uff55.hpp"
#include "gui/geometry/structure.hpp"

namespace jointid::gui {

/// A shape to be chosen for its name: "2: 144.6 Hz, shapes.uff".
struct NamedShape {
  QString name;
  Shape shape;
};

/// Translations of the modes of a modal model; `from` says whose they are.
std::vector<NamedShape> named_shapes(const std::vector<frf::Uff55Mode>& modes, const QString& from);

/// How the nodes of the joint move against each other, in global axes: their motion less its mean, nothing of other nodes. As it
/// is, where the joint has less than two nodes that move.
Shape joint_deflection(const Shape& shape, const std::vector<frf::Dof>& joint);

/// "4:+Y 1.2e-06 ∠ 10°, 5:+Y …": what the translations of the joint do in a motion; DOFs that it does not have are left out.
QString joint_motion_text(const Shape& shape, const std::vector<frf::Dof>& joint);

}  // namespace jointid::gui
