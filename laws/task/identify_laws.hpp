#pragma once

#include <string>
#include <vector>

#include "base/status.hpp"
#include "laws/data/level_states.hpp"
#include "laws/task/level_findings.hpp"
#include "response/identify/consistency.hpp"
#include "response/identify/direct_step.hpp"
#include "response/identify/law_choice.hpp"

namespace jointid::laws {

/// Laws of the joints of a scene from its measured states.
struct LawIdentification {
  Status status = Status::ok;
  std::string message;  ///< why, and what helps; empty when ok
  LevelStates data;
  response::Consistency consistency;             ///< of the states with the parts, whatever the laws are
  std::vector<response::DirectStep> steps;       ///< of each state, no law in them
  std::vector<response::LawCandidate> compared;  ///< best first
  std::vector<response::LevelDrift> drifts;      ///< of every level, the one that speaks most against the others first
  std::vector<OneSidedJoint> one_sided;          ///< of every joint
  std::size_t chosen = 0;                        ///< of compared
  std::vector<std::string> not_told_apart;       ///< laws whose χ² is larger by less than chance makes it, the chosen one aside
  std::vector<std::string> notes;                ///< one phrase each

  const response::LawFit& fit() const { return compared[chosen].fit; }
  const std::vector<std::string>& laws() const { return compared[chosen].laws; }
};

/// "ren", or "ren + iwan" of two joints.
std::string laws_text(const std::vector<std::string>& laws);

/// What the states do not show of the joints, one phrase each, with the joint's name.
std::vector<std::string> unseen(const LawScene& scene, const std::vector<response::FittedJoint>& joints);

/// Throws InputError (data) that names a level which is only planned.
void require_measured(const LawScene& scene);

/// F and Q of every state without a law.
std::vector<response::DirectStep> direct_steps(const LevelStates& data);

/// Reads the files of the scene, fits every combination of its laws and chooses one. Throws InputError where read_level_states or
/// the fits do, and (data) for a level that is only planned, Interrupted where `work` is; what the numbers are worth is the
/// status.
LawIdentification identify_laws(const LawScene& scene, const response::FitWork& work = {});

/// The same of states that are there.
LawIdentification identify_states(const LawScene& scene, LevelStates data, const response::FitWork& work = {});

}  // namespace jointid::laws
