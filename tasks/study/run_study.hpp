#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "study/study.hpp"
#include "study/study_statistics.hpp"

namespace jointid::tasks {

/// A Monte-Carlo study: what `jointid study` finds.
struct StudyResult {
  std::string title;  ///< of the scene
  std::string file;   ///< that keeps all trials: study::StudyOptions::out
  std::uint64_t seed = 1;
  study::StudyRun run;
  study::StudyStatistics statistics;  ///< SI units; of all trials, empty unless run.complete
  std::vector<std::string> notes{};   ///< what the user should know, one sentence each
};

/// What a result file keeps of where it came from, beside what study::run_study() keeps: scene_hash (of scene::contents_of(), so
/// that a title or a comment makes no other study) and jointid_version. For
/// study::StudyOptions::texts.
std::map<std::string, std::string> study_texts(const std::string& scene_text);

/// Runs the trials that options.out lacks (study::run_study()) and reads their statistics. `data`: study::load_trial_data(), or
/// study::make_trial_data() of sets in memory. Interrupted, run.complete is false, and the next run with options.resume
/// continues. Throws InputError.
StudyResult run_study(const std::shared_ptr<const study::TrialData>& data, const study::StudyOptions& options,
                      const study::StudyControl& control = {});

/// The same shared by the processes of a team; only the result of its leader tells of all.
StudyResult run_study(const std::shared_ptr<const study::TrialData>& data, const study::StudyOptions& options, ident::Team& team,
                      const study::StudyControl& control = {});

/// "hysteretic damping is off by 300 % rms over the trials": of a matrix that a solution does not tell, being off by more than
/// its own size against the truth; without a truth, of unknowns that scatter by more than their mean where most do. Empty: there
/// is none.
std::string study_doubt(const study::StudyStatistics& statistics);

}  // namespace jointid::tasks
