#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "laws/task/law_study.hpp"

namespace jointid::tasks {

/// File of the trials of a study of friction laws, to continue an interrupted one.
struct LawTrialsFile {
  std::filesystem::path path;  ///< CSV
  std::string scene_text;      ///< of the scene's file: trials of another scene do not continue this study
  bool resume = false;         ///< continue the trials of the file
};

/// laws::study_laws_together() with the trials in a file: `jointid study` for a scene of friction laws. `options.known` and
/// `options.made` are those of the file; `options.progress` first gets its number of trials. The leader of the team returns the
/// study, the others nothing. Throws InputError as laws::TrialFile and laws::study_laws(), and Interrupted.
std::optional<laws::LawStudy> run_law_study(const laws::LawScene& scene, const LawTrialsFile& trials,
                                            laws::LawStudyOptions options, ident::Team& team);

/// The same by one process.
laws::LawStudy run_law_study(const laws::LawScene& scene, const LawTrialsFile& trials, laws::LawStudyOptions options);

}  // namespace jointid::tasks
