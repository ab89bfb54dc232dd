#pragma once

#include <memory>
#include <string>
#include <vector>

#include "laws/data/phasor_file.hpp"
#include "laws/scene/law_scene.hpp"
#include "response/identify/measured_state.hpp"
#include "response/structure/frf_receptance.hpp"

namespace jointid::laws {

/// The measured states of a scene over the FRFs of its parts.
struct LevelStates {
  std::shared_ptr<const response::FrfReceptance> structure;
  std::vector<frf::Dof> responses;              ///< of the structure and of every state
  std::vector<response::MeasuredState> states;  ///< level by level, of each ascending in frequency
  std::vector<std::size_t> level;               ///< of each state
  std::vector<std::string> notes;               ///< what was left out, one phrase each
};

/// Reads the files of a scene. Levels that are only planned get states at the lines of [frequency] that the parts have at all of their
/// harmonics, with forces and without responses: phasors of 0 with deviations of 1. States are the lines of [frequency] that a level
/// and the parts have; a harmonic whose line nω one of them lacks, or with a phasor that was not measured, is left out of a state, and
/// told. Throws InputError (data) for files that do not hold what the scene says, phasors of which nobody says how exact they are, and
/// when nothing is left.
LevelStates read_level_states(const LawScene& scene, PhasorFiles files = {});

}  // namespace jointid::laws
