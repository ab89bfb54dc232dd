#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "friction/path/element.hpp"
#include "problems/case/write_options.hpp"
#include "problems/structure/structure.hpp"
#include "response/identify/measured_state.hpp"
#include "response/structure/frf_receptance.hpp"

namespace jointid::problems {

/// A friction joint of a problem with its true law.
struct LawProblemJoint {
  std::string name;
  response::JointEnds ends;
  std::string law;
  std::vector<double> parameters;
  std::vector<std::string> candidates;  ///< laws that the scene names
};

/// Structures with friction joints, vibrating under a sine at several force levels. Its answer is the law of every joint.
struct LawProblem {
  std::string name, description;
  std::vector<Structure> parts;
  std::vector<LawProblemJoint> joints;
  std::vector<frf::Dof> responses;
  frf::Dof force;
  std::vector<double> levels;        ///< N
  std::vector<double> frequency_hz;  ///< of the force
  std::vector<int> measured = {1, 3};
  std::vector<int> model = {1, 3, 5, 7, 9};  ///< harmonics of the true motion; the parts' FRFs are given at one more
  double noise = 0.01;                       ///< circular, of phasors
  bool noisy_parts = true;                   ///< and of the parts' FRFs; else these are exact, as of a model
};

/// What was measured: a file for each part, and one of responses and one of forces for each level, without noise, their lines at
/// all harmonics.
struct LawMeasurement {
  std::vector<frf::FrfSet> parts, responses, forces;
};

/// Periodic responses by harmonic balance with all harmonics of the model. The force is a cosine with a third harmonic of 2 %, as
/// of a shaker.
LawMeasurement measure(const LawProblem& problem);

/// With the problem's circular noise on responses and perhaps parts, whose files tell their variances.
LawMeasurement polluted(const LawProblem& problem, LawMeasurement exact, std::uint64_t seed);

/// A measurement as what a fit takes.
struct LawStates {
  std::shared_ptr<const response::FrfReceptance> structure;
  std::vector<response::MeasuredState> states;  ///< level by level
};
/// Deviations are those of the sets; where they tell none, the problem's noise of each phasor.
LawStates states_of(const LawProblem& problem, const LawMeasurement& measured);

/// Writes files, NAME.toml and truth.json into `directory` and returns the scene's path.
std::filesystem::path write(const LawProblem& problem, const std::filesystem::path& directory, const WriteOptions& options);

}  // namespace jointid::problems
