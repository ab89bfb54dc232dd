#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "study/study.hpp"
#include "study/study_statistics.hpp"

namespace jointid::tasks {

/// A Monte-Carlo study: the result of `jointid study`.
struct StudyResult {
  std::string title;  ///< of the scene
  std::string file;   ///< with all trials: study::StudyOptions::out
  std::uint64_t seed = 1;
  study::StudyRun run;
  study::StudyStatistics statistics;  ///< SI units; of all trials, empty unless run.complete
  std::vector<std::string> notes{};   ///< notes for the user, one sentence each
};

/// Origin that a result file keeps in addition to that of study::run_study(): scene_hash (of scene::contents_of(), so that a title
/// or a comment makes no other study) and jointid_version. For
/// study::StudyOptions::texts.
std::map<std::string, std::string> study_texts(const std::string& scene_text);

/// Runs the missing trials of options.out (study::run_study()) and reads their statistics. `data`: study::load_trial_data(), or
/// study::make_trial_data() of sets in memory. If interrupted, run.complete is false, and the next run with options.resume
/// continues. Throws InputError.
StudyResult run_study(const std::shared_ptr<const study::TrialData>& data, const study::StudyOptions& options,
                      const study::StudyControl& control = {});

/// The same, shared by the processes of a team. Only the result of its leader is complete.
StudyResult run_study(const std::shared_ptr<const study::TrialData>& data, const study::StudyOptions& options, ident::Team& team,
                      const study::StudyControl& control = {});

/// The study of which `files` are the parts (StudyOptions::part), written to `out`: the statistics of a study in one run, to the last
/// bit. Throws InputError as study::merge_parts(), and where `scene_text` is there and of another scene.
StudyResult merge_study(const std::vector<ident::Path>& files, const ident::Path& out, const std::string& scene_text = {});

/// "hysteretic damping is off by 300 % rms over the trials": a matrix that one solution does not determine. With a truth,
/// its error is larger than itself; without one, most of its unknowns scatter by more than their mean. Empty if there is
/// none.
std::string study_doubt(const study::StudyStatistics& statistics);

}  // namespace jointid::tasks
