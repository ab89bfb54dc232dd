#pragma once

#include <string>
#include <vector>

#include "cli/frf/frf_arguments.hpp"
#include "records/estimate/measured_frfs.hpp"

namespace jointid::cli {

/// What was read and what came of it.
struct FrfRun {
  std::vector<std::string> record_files;  ///< by record
  std::vector<double> rate_hz;            ///< by record
  std::size_t forces = 1;                 ///< at once
  records::FrfOptions options;
  records::MeasuredFrfs made;
  std::vector<std::string> delays;  ///< of channels that begin later than the first, one sentence per file
};

/// Reads the files and makes the FRFs. Throws InputError, Interrupted.
FrfRun run_frf(const FrfArguments& arguments);

/// Seconds from the beginning of its record to a stretch.
double begin_s(const FrfRun& run, const records::Blow& blow);

/// Coherences of response r and reference c, lines without one left out.
std::vector<double> coherences(const FrfRun& run, std::size_t r, std::size_t c);

}  // namespace jointid::cli
