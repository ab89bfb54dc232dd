#pragma once

#include "ident/admissible/admissible_fit.hpp"
#include "ident/plan/joint_impedance.hpp"

namespace jointid::ident {

/// The condition of one frequency at the motion that a joint has there, coefficients·θ = value, and what its error depends on.
struct FrequencyCondition {
  double frequency_hz = 0.0;
  Eigen::VectorXd coefficients;
  double value = 0.0;
  Eigen::VectorXd motion;
  std::vector<std::size_t> lines;  ///< of the substructures, between which H_bb⁻¹ is interpolated
  std::vector<double> weights;     ///< of these in its polynomial
  double rough = 0.0;  ///< what a straight line in place of the parabola, and a thousandth of the frequency, change of the value
};

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

  /// At the motions of a joint θ, one per frequency.
  std::vector<FrequencyCondition> conditions_at(const Eigen::VectorXd& theta) const;

 private:
  /// Re H_bb⁻¹ at a frequency, by the lines nearest to it.
  struct PartStiffness {
    Eigen::MatrixXd value;
    std::vector<Eigen::MatrixXd> doubts;  ///< what another interpolation, and a slightly different frequency, change of it
    std::vector<std::size_t> lines;
    std::vector<double> weights;
  };
  struct Mode {
    double frequency_hz = 0.0;
    PartStiffness stiffness;
    JointImpedance joint;
  };
  static PartStiffness part_stiffness(const Plan& plan, double hz);
  static FrequencyCondition condition(const Mode& mode, const Eigen::VectorXd& theta);

  std::vector<Mode> modes_;
};

/// Whether the frequencies of a scene are its data in place of FRFs: it asks which joints are loose, by a method that reads no FRFs at the
/// joints of the assembly.
bool frequencies_are_data(const Scene& scene);

/// Throws InputError for a scene whose frequencies cannot be conditions: outside the lines of the substructures, of a method that
/// is not linear, or without H_bb.
void require_frequencies(const Plan& plan);

}  // namespace jointid::ident
