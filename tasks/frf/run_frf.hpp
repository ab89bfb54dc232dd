#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ident/result/control.hpp"
#include "records/estimate/measured_frfs.hpp"
#include "records/file/read_record.hpp"

namespace jointid::tasks {

/// Which time records FRFs are made of, and how, in the words of `jointid frf`.
struct FrfTask {
  std::vector<std::filesystem::path> files;
  records::RecordOptions read;
  std::vector<frf::Dof> references;  ///< of the force: none (as the channels say), one, or one per file
  bool shaker = false;               ///< segments of a long record in place of impacts
  records::SegmentOptions segments;
  std::optional<double> block_s;  ///< of an impact or a segment; empty: every file is one impact, whole
  records::FrfOptions options;    ///< but for `segments`, which `shaker` decides
};

/// The options of the estimate, with those of the segments. Throws InputError (usage) for a shaker without `block_s`.
records::FrfOptions estimate_options(const FrfTask& task);

/// What was read and what came of it.
struct FrfRun {
  std::vector<std::string> record_files;  ///< by record
  std::vector<double> rate_hz;            ///< by record
  std::size_t forces = 1;                 ///< at once
  records::FrfOptions options;
  records::MeasuredFrfs made;  ///< FRFs (receptances, m/N) with coherences, variances and covariances; the impacts and averages
  std::vector<std::string> delays;  ///< of channels that begin later than the first, one sentence per file
};

/// Reads the files and makes the FRFs. Throws InputError, and Interrupted. Records in memory: records::make_frfs().
FrfRun run_frf(const FrfTask& task, const ident::Control& control = {});

/// Seconds from the beginning of its record to an impact or a segment.
double begin_s(const FrfRun& run, const records::Blow& blow);

/// Coherences of response r and reference c, lines without one left out.
std::vector<double> coherences(const FrfRun& run, std::size_t r, std::size_t c);

}  // namespace jointid::tasks
