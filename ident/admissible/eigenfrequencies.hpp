#pragma once

#include "ident/admissible/admissible_fit.hpp"
#include "ident/plan/joint_impedance.hpp"

namespace jointid::ident {

/// The eigenfrequencies of the assembly that a scene states, as conditions on the joint: at each the dynamic stiffness of the
/// parts and the joint at the joint coordinates, Re(H_bb⁻¹ + Z_j(θ)), is singular. H_bb is interpolated between the lines of the
/// substructures, as Re H_bb⁻¹ over ω². Damping moves a frequency by its square, which is left out.
class Eigenfrequencies {
 public:
  /// Reads H_bb about each frequency. Throws InputError where it is not measured there.
  explicit Eigenfrequencies(const Plan& plan);

  /// The estimate θ̂ moved to the nearest joint of `set` (empty: any) that has them, in the metric ‖R(θ − θ̂)‖: each turn has the
  /// motions at these frequencies of the turn before, with which a condition is vᵀ Re(H_bb⁻¹ + Z(θ)) v = 0, linear in θ. `within`
  /// gets the set with the last of these conditions among its ties. `converged` is false where motions did not settle.
  AdmissibleFit nearest(const AdmissibleSet* set, const Eigen::VectorXd& theta, const Eigen::MatrixXd& root, double unit,
                        AdmissibleSet& within) const;

 private:
  struct Mode {
    double frequency_hz = 0.0;
    Eigen::MatrixXd stiffness;  ///< Re H_bb⁻¹
    JointImpedance joint;
  };
  /// Of the motion nearest to an eigenvector: coefficients·θ = value.
  void add_condition(const Mode& mode, const Eigen::VectorXd& theta, Eigen::MatrixXd& rows, Eigen::VectorXd& values,
                     Eigen::Index row) const;

  std::vector<Mode> modes_;
};

/// Throws InputError for a scene whose frequencies cannot be conditions: outside the lines of the substructures, of a method that
/// is not linear, or without H_bb.
void require_frequencies(const Plan& plan);

}  // namespace jointid::ident
