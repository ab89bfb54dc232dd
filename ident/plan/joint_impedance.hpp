#pragma once

#include "ident/plan/unknown_columns.hpp"
#include "restrictions/joint_impedance.hpp"

namespace jointid::ident {

using ComplexMatrix = Eigen::MatrixXcd;
using restrictions::ImpedancePart;
using restrictions::ImpedanceShape;
using restrictions::ImpedanceTerm;
using restrictions::JointImpedance;

/// The joint at ω (rad/s) with the columns of that line; without unknowns where it lies in no band.
JointImpedance joint_at(const restrictions::Restriction& restriction, const UnknownColumns& columns, double omega0, double omega);

}  // namespace jointid::ident
