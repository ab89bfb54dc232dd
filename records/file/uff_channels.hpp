#pragma once

#include <string>
#include <vector>

#include "frf/uff/uff_scan.hpp"
#include "records/file/record.hpp"

namespace jointid::records {

/// A time response (function type 1) of a universal file, and where its samples stand.
struct UffChannel {
  std::string name;
  frf::Dof dof;
  ChannelKind kind = ChannelKind::force;
  double to_si = 1.0;
  frf::uff::Dataset dataset;

  /// Samples per second; `abscissa`: the first two of an uneven one, or more, in the file's unit. Throws InputError for another
  /// abscissa than even times.
  double rate_hz(const std::string& file, const std::vector<double>& abscissa) const;
};

/// The time responses run by run: a channel (DOF and kind) that is there already begins the next one. Records with other
/// functions are passed over. Throws InputError for a channel that is no force or motion, complex values, responses without
/// direction, and where there is no time response.
std::vector<std::vector<UffChannel>> uff_runs(frf::uff::ByteFile& file);

}  // namespace jointid::records
