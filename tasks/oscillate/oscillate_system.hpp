#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "oscillation/reduction/reduction_error.hpp"
#include "oscillation/system/timoshenko.hpp"
#include "oscillation/system/thesis_systems.hpp"

namespace jointid::tasks {

/// [system] kind.
enum class SystemKind { belt_chain, cantilever, matrices };

/// What is seen of a system: linear forms of q.
struct SeenForm {
  std::string name, unit;
  Eigen::RowVectorXd row;
};

/// C = cK; c for the share of the first mode; or the same share in every mode.
enum class DampingKind { stiffness, first_mode, modal };

/// [system] and [friction] of a scene, with the numbers that a sweep may vary in their place.
struct SystemSpec {
  SystemKind kind = SystemKind::belt_chain;
  oscillation::BeltChain chain;     ///< of a belt chain: masses, mass, stiffness
  oscillation::Cantilever beam;     ///< of a cantilever: all but damping, drive and friction
  Eigen::MatrixXd mass, stiffness;  ///< of matrices
  Eigen::VectorXd contact;          ///< p of matrices
  std::vector<double> points;       ///< of a cantilever, where its displacement is seen, m
  double strain_at = 0.05;          ///< of a cantilever, m
  DampingKind damping_kind = DampingKind::stiffness;
  double damping = 0.0;
  double velocity = 0.0, amplitude = 0.0, frequency_hz = 0.0;  ///< of what the contact slides on
  std::vector<std::array<double, 2>> amplitudes;  ///< rows of Hz and m, Hz ascending: A by the frequency; empty: `amplitude`
  std::optional<double> poisson_ratio;            ///< of a cantilever whose shear and rotary inertia are asked for
  oscillation::Friction friction;

  bool is_driven() const { return frequency_hz > 0.0 && drive_amplitude() != 0.0; }
  /// A at the frequency, m: linear between the rows of `amplitudes`, constant outside.
  double drive_amplitude() const;
};

/// Names of the numbers that a sweep may vary: "velocity", "frequency", "normal" …
std::vector<std::string> swept_names();
/// Its unit.
std::string swept_unit(std::string_view name);
/// Sets it; `name` is one of swept_names().
void set_swept(SystemSpec& spec, std::string_view name, double value);

/// The beam of a cantilever with all that hangs on its tip as a point mass. `poisson_ratio` must be there.
oscillation::ThickBeam thick_beam(const SystemSpec& spec);

/// The model, and the displacements seen of it. Throws InputError.
oscillation::Model model_of(const SystemSpec& spec);
std::vector<SeenForm> seen_forms(const SystemSpec& spec);
/// The form that reduced models are judged by beside ΔX and ΔE: the strain of a cantilever, else the contact's displacement.
SeenForm judged_form(const SystemSpec& spec);

}  // namespace jointid::tasks
