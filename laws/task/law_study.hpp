#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ident/team/team.hpp"
#include "laws/scene/law_scene.hpp"
#include "laws/task/assumed_states.hpp"
#include "laws/task/law_trial.hpp"
#include "response/identify/law_fit.hpp"

namespace jointid::laws {

/// One number of a joint over the trials whose laws are those assumed and whose fit is usable.
struct StudiedValue {
  std::string joint, name, unit;
  double truth = 0.0, bound = 0.0;     ///< bound: its deviation there; NaN where the data do not see it
  std::size_t trials = 0, covered = 0; ///< that tell it; whose 95 % interval holds the truth
  double bias = 0.0, rms_error = 0.0;  ///< over those trials; NaN without one
  std::vector<double> found{};         ///< by each of those trials
};

/// How well levels tell the laws of joints, over trials with simulated noise.
struct LawStudy {
  std::vector<std::string> laws;  ///< assumed
  bool assumed = true;            ///< told by the scene, else found from the measured levels
  std::size_t trials = 0, usable = 0, contradicting = 0;
  std::map<std::string, std::size_t> chosen;    ///< how often each combination of laws was
  std::size_t right = 0;                        ///< usable trials whose chosen laws are the true ones …
  std::size_t undecided = 0;                    ///< … that name others which the data cannot tell from those chosen …
  std::size_t missed = 0;                       ///< … that name the true ones neither as chosen nor among those
  std::map<std::string, std::size_t> statuses;  ///< … and each status
  double chi_square = 0.0;                      ///< mean of χ² over its freedom, of the usable ones
  std::vector<StudiedValue> values;             ///< of each joint stiffness, limit and parameters
  std::vector<std::string> notes;
};

/// What a study is of: laws, truth and bounds of its values; no trial.
LawStudy law_study_plan(const LawScene& scene, const AssumedStates& assumed);

/// Mean and root mean square of errors; NaN without one.
struct TrialErrors {
  double bias = 0.0, rms = 0.0;
};
TrialErrors errors_about(double truth, const std::vector<double>& found);

/// Each trial draws the true FRFs of the parts about those of the files, by the files' variances, solves harmonic balance of the
/// assumed laws over them, draws the phasors of responses and forces about these states, and identifies as identify_laws does,
/// with the harmonics of the assumed states. Trial t depends on the seed and t alone, whatever the threads. Throws InputError as
/// predict_law_bound, Interrupted when it is interrupted.
LawStudy study_laws(const LawScene& scene, const LawStudyOptions& options);

/// The same study shared by the processes of a team: each makes a part of the trials on its own threads. The leader is told of
/// each as if it were its own (made, progress) and returns the study; the trials that are known need be given to it alone. The
/// others return nothing. Throws as study_laws(), and in the leader InputError when another process fails.
std::optional<LawStudy> study_laws_together(const LawScene& scene, const AssumedStates& assumed, const LawStudyOptions& options,
                                            ident::Team& team);

}  // namespace jointid::laws
