#pragma once

#include <span>
#include <vector>

#include "frf/hdf5/table_file.hpp"
#include "study/trial_runner.hpp"

namespace jointid::study {

/// Where the numbers of a trial stand in a row of the result file.
struct StudyColumns {
  std::size_t unknowns = 0;
  std::vector<std::string> judged;  ///< keys of the matrices with figures of merit
  bool intervals = false;

  static constexpr std::size_t status = 0;
  std::size_t value(std::size_t unknown) const { return 1 + unknown; }
  /// RJCF; ARVF and rms relative error follow.
  std::size_t quality(std::size_t matrix) const { return 1 + unknowns + 3 * matrix; }
  /// Lower end; the upper follows.
  std::size_t interval(std::size_t unknown) const { return 1 + unknowns + 3 * judged.size() + 2 * unknown; }
  std::size_t count() const { return 1 + unknowns + 3 * judged.size() + (intervals ? 2 * unknowns : 0); }
};

StudyColumns columns_of(const TrialData& data, bool intervals);

/// The same as a result file tells it. Throws InputError when it is no study.
StudyColumns columns_of(const frf::TableHeader& header);

/// Names, units and truths of the columns, and the texts that columns_of() reads.
frf::TableHeader header_of(const TrialData& data, const StudyColumns& columns);

void fill_row(const Trial& trial, const StudyColumns& columns, std::span<double> row);

}  // namespace jointid::study
