#pragma once

#include <filesystem>
#include <fstream>
#include <vector>

#include "laws/task/law_study.hpp"

namespace jointid::laws {

/// What a file of trials is of: trials of another study do not continue this one.
struct TrialFileKey {
  std::string scene;  ///< its text
  std::uint64_t seed = 1;
  LawStudy plan;  ///< law_study_plan(): laws, truth and bounds, which change with the data
};

/// The trials of a study of laws, a line of text each (CSV after lines that begin with #), in the order in which they were made.
/// Each line stands in the file as soon as the trial is made, so that an interrupted study leaves what it has.
class TrialFile {
 public:
  /// A new file, or with `resume` the one that is there, whose trials are known() then; a last line that is not whole is dropped.
  /// Throws InputError where the file cannot be written, or has trials of another scene, seed or data.
  TrialFile(std::filesystem::path path, const TrialFileKey& key, bool resume);

  const std::vector<LawTrial>& known() const { return known_; }
  void add(const LawTrial& trial);

 private:
  void read(const std::string& head);

  std::filesystem::path path_;
  std::size_t values_;
  std::vector<LawTrial> known_;
  std::ofstream out_;
};

}  // namespace jointid::laws
