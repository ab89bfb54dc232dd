#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "frf/hdf5/record_journal.hpp"
#include "frf/hdf5/table_file.hpp"
#include "study/study_options.hpp"

namespace jointid::study {

/// The files of a study, which the leader alone has: the journal OUT.partial, and OUT once all trials are there.
class StudyRecords {
 public:
  /// To resume, a journal is continued, and a result of fewer trials, too. Throws InputError when either is of another study, and says
  /// what differs: scene, data, seed, version or unknowns.
  StudyRecords(const StudyOptions& options, frf::TableHeader header);

  /// Trials that are still to be run.
  std::vector<frf::IndexRange> missing() const;

  /// From any thread.
  void put(std::size_t trial, std::span<const double> row);
  void sync() const;

  /// Writes OUT from the journal in the order of the trials, a few thousand rows in memory at a time.
  void finish();

 private:
  std::size_t finished_trials() const;
  void take_over(std::size_t finished);
  [[noreturn]] void refuse(const std::string& problem) const;

  const StudyOptions& options_;
  frf::TableHeader header_;
  std::size_t rows_ = 0;                       ///< of OUT: the trials of options_.part
  std::optional<frf::RecordJournal> journal_;  ///< none when OUT is complete
};

/// "3/16". Throws InputError (usage) for what is none, and unless 1 ≤ number ≤ count.
StudyPart parse_part(const std::string& text);

/// The trials of a part, about as many as any other part has: [n(k−1)/K, nk/K) of n trials for part k of K.
frf::IndexRange trials_of(const StudyPart& part, std::size_t trials);

/// Texts that the file of a part has beside those of the study; none of a whole study.
std::map<std::string, std::string> texts_of(const StudyPart& part, std::size_t trials, const std::string& title,
                                            const std::vector<std::string>& notes);

/// A study put together of its parts.
struct MergedStudy {
  std::string title, scene_hash;
  std::vector<std::string> notes;  ///< of the data
  std::uint64_t seed = 1;
  std::size_t trials = 0;
};

/// Writes the study of which `files` are the parts, in any order: the same bytes as a study in one run. Throws InputError that names
/// the file or part for a part that is missing, there twice or of another study, and for files that are no whole parts.
MergedStudy merge_parts(std::span<const ident::Path> files, const ident::Path& out);

}  // namespace jointid::study
