#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "frf/set/frf_set.hpp"
#include "ident/scene/scene.hpp"

namespace jointid::study {

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
  ident::Scene scene;  ///< for the excerpt: all its lines, the equations that the whole data allow
  Measurements base;
  Pollution pollution;
  std::vector<TrialUnknown> unknowns;
  std::vector<restrictions::Kind> judged;  ///< matrices with a truth, in the order of Trial::quality
  std::size_t equations_per_line = 0, lines = 0;
  std::vector<std::string> notes;  ///< what the user should know, one sentence each
};

}  // namespace jointid::study
