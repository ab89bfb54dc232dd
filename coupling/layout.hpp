#pragma once

#include <string>
#include <vector>

#include "coupling/assembly.hpp"
#include "coupling/condition.hpp"

namespace jointid::coupling {

/// A coordinate of a part, with the sign that the part gives it.
struct Coordinate {
  std::size_t part = 0;
  frf::Dof dof;
};

/// A response or reference of the result: of the coordinate's FRFs in H, or of a coordinate that conditions or joints name.
struct ResultDof {
  Coordinate coordinate;
  Index connected = -1;  ///< its index among Layout::connected, or −1
  double sign = 1.0;     ///< of the result's DOF to the coordinate's
  frf::Dof dof;          ///< as the result names it
};

/// The joints as one, over some of the connected coordinates; real matrices [n, n].
struct LayoutJoint {
  std::vector<Index> at;
  Eigen::MatrixXd stiffness, mass, viscous_damping, hysteretic_damping;

  /// Of the joints that were identified, one after the other: derivatives by their unknowns, p in all, without an `at` of their own.
  std::vector<LayoutJoint> by_unknown{};
  Eigen::MatrixXd covariance{};  ///< [p,p]
  std::vector<std::shared_ptr<const JointUncertainty>> identified{};

  /// E[ε θ_m] of an FRF, [p].
  std::vector<Complex> common(const std::string& part, const frf::Dof& row, const frf::Dof& column, double hz) const;

  /// Z at ω (rad/s).
  ComplexMatrix dynamic_stiffness(double omega) const;
};

/// An assembly in numbers.
struct Layout {
  std::vector<Coordinate> connected;        ///< that conditions or joints name; first in every H
  Conditions conditions;                    ///< in the order declared, none that others imply
  std::vector<std::string> condition_names; ///< "4:+Y = 5:+Y", "9:+Y = 0"
  LayoutJoint joint;                        ///< `at` empty: none
  std::vector<double> part_sign;            ///< −1 for parts taken out
  std::vector<ResultDof> responses, references;
};

/// Finds the coordinates of an assembly and its conditions. Throws InputError with `where` as file: DOFs that no part has, or
/// several and without a part, or not in both roles; conditions that contradict each other; coordinates that would stand
/// twice in the result.
Layout make_layout(const std::vector<Part>& parts, const Assembly& assembly, const std::string& where);

/// The structure of each coordinate for rc(): the file it is in.
std::vector<std::size_t> bodies(const std::vector<Part>& parts, const std::vector<Coordinate>& coordinates);

}  // namespace jointid::coupling
