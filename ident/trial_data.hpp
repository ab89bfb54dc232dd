#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frf/excerpt.hpp"
#include "frf/noise.hpp"
#include "ident/plan.hpp"
#include "ident/scene.hpp"

namespace jointid::ident {

/// FRFs of a test, set by set as the scene's [data] lists them.
struct Measurements {
  std::vector<frf::FrfSet> substructures, assembly;
};

/// Puts the errors of one trial on a copy of the base data, in place. Set i of a trial has the stream (seed, trial, i),
/// substructures first. Every runner works on a copy of its own, so it may carry scratch memory.
using Pollution = std::function<void(std::uint64_t seed, std::uint64_t trial, Measurements& data)>;

/// An unknown as the trials report it: one per column of the plan.
struct TrialUnknown {
  std::string name, unit;
  restrictions::Kind kind = restrictions::Kind::stiffness;
  std::optional<double> truth;  ///< when the scene's [truth] fixes it
};

/// What the runners of a study share: base data (just the lines and DOFs that the plan needs; all lines when variances are
/// estimated from the scatter) and what is put on them. Sets and scene say the noise of the trials, see declare_noise().
struct TrialData {
  Scene scene;  ///< for the excerpt: all its lines, the equations that the whole data allow
  Measurements base;
  Pollution pollution;
  std::vector<TrialUnknown> unknowns;
  std::vector<restrictions::Kind> judged;  ///< matrices with a truth, in the order of Trial::quality
  std::size_t equations_per_line = 0, lines = 0;
  std::vector<std::string> notes;  ///< what the user should know, one sentence each
};

/// Opens the scene's files, loads what the plan needs once, and takes the noise of [noise] (without that section: of a hammer
/// test when all files carry coherences). Throws InputError as make_plan() does, and for a noise that the data do not allow.
std::shared_ptr<const TrialData> load_trial_data(const Scene& scene);

/// The same from sets in memory, with errors of any kind.
std::shared_ptr<const TrialData> make_trial_data(const Scene& scene, const Measurements& base, Pollution pollution);

/// The same from sets in memory with a noise model.
std::shared_ptr<const TrialData> make_trial_data(const Scene& scene, const Measurements& base, const frf::NoiseModel& noise);

}  // namespace jointid::ident
