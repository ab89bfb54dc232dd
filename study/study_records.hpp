#pragma once

#include <optional>

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

}  // namespace jointid::study
