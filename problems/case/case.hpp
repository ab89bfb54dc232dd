#pragma once

#include <optional>
#include <string>
#include <vector>

#include "frf/set/quantity.hpp"
#include "problems/case/identification_problem.hpp"
#include "problems/case/problem_noise.hpp"
#include "problems/structure/structure.hpp"

namespace jointid::problems {

/// One matrix of a joint: its exact value and how the scene declares it.
struct JointMatrix {
  Kind kind = Kind::stiffness;
  Matrix truth;                   ///< N×N over the case's joint DOFs
  restrictions::MatrixSpec spec;  ///< symmetric pattern, entries or springs
  std::vector<ExactUnknown> unknowns;
};

/// Declared as symmetric; unknowns are the upper triangle row by row.
JointMatrix symmetric(Kind kind, Matrix truth);

/// Declared entry by entry; `letters` are the exact values of the entries' names.
JointMatrix expressed(Kind kind, const Matrix& truth, restrictions::EntryMatrix entries,
                      const std::vector<ExactUnknown>& letters);

/// Declared as springs, each its own unknown; `values` in their order.
JointMatrix springs(Kind kind, const std::vector<frf::Dof>& joint_dofs, std::vector<restrictions::Spring> springs,
                    const std::vector<double>& values);

/// Lines start, start + step, …
struct Axis {
  double start_hz = 0.0;
  double step_hz = 0.0;
  std::size_t lines = 0;
};
std::vector<double> frequencies(const Axis& axis);

/// Coherence of a hammer test whose signal-to-noise ratio is limited by `ceiling` everywhere and by a noise
/// floor of the accelerometer where the structure hardly moves: (1−γ²)/γ² = (1−ceiling)/ceiling +
/// (floor/|A|)², A the accelerance.
struct HammerCoherence {
  double ceiling = 0.999;
  double accelerance_floor = 0.04;  ///< (m/s²)/N
};

/// The definition of a problem, from which make() computes FRFs and writes the scene.
struct Case {
  std::string name;
  std::string description;
  std::vector<Structure> substructures;
  Structure assembly;
  std::vector<frf::Dof> joint_dofs;
  std::vector<JointMatrix> joint;
  std::vector<frf::Dof> measured_substructures;  ///< empty: all DOFs
  std::vector<frf::Dof> measured_assembly;       ///< empty: all DOFs
  Axis axis;
  bool exclude_resonances =
      false;  ///< leave out lines within 1 % of the natural frequencies of parts and assembly

  std::string method = "one";
  std::vector<std::string> equations;  ///< empty: all that the data allow
  std::string weighting = "WB";        ///< empty: the method has its own
  double delta = 0.0;
  std::optional<Matrix> start_stiffness;  ///< iterative methods
  std::optional<Matrix> start_damping;    ///< hysteretic, beside start_stiffness

  ProblemNoise noise = frf::NoiseModel{};
  std::optional<HammerCoherence> hammer;  ///< with a hammer noise model
  frf::Quantity quantity = frf::Quantity::receptance;
  double window_rate = 0.0;         ///< 1/s, exponential window
  double accelerometer_mass = 0.0;  ///< kg, roving

  /// FRFs of the parts from all their modes, of the assembly by coupling these with the joint's springs: the quick way where damping
  /// of the parts is proportional, all measured DOFs are those of parts, and K and D of the joint are the same springs.
  bool coupled_by_springs = false;
};

/// The parts side by side with the joint matrices between them.
Structure assembled(const std::vector<Structure>& parts, const std::vector<frf::Dof>& joint_dofs,
                    const std::vector<JointMatrix>& joint);

/// Computes the FRFs, the modes and the scene.
Problem build(const Case& definition);

/// The TOML scene of a case; `problem` has its FRF sets (file names) and modes already.
std::string scene_text(const Case& definition, const Problem& problem);

}  // namespace jointid::problems
