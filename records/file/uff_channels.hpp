#pragma once

#include <optional>
#include <string>
#include <vector>

#include "frf/uff/uff_scan.hpp"
#include "records/file/record.hpp"

namespace jointid::records {

/// A time response (function type 1) of a universal file, and where its samples stand.
struct UffChannel {
  std::string name;
  std::optional<frf::Dof> dof = {};      ///< none where the record has no direction
  std::optional<ChannelKind> kind = {};  ///< none: no force or motion of a coordinate, or a unit that is not understood
  double to_si = 1.0;
  std::string unit = {};     ///< in SI; of what is no force or motion the file's own, with to_si = 1
  std::string stated = {};   ///< the unit as the file states it, its label, else that of dataset 164; empty: nothing
  std::string problem = {};  ///< why it is no force or motion
  frf::uff::Dataset dataset;

  /// Samples per second and when the first one was taken.
  struct Times {
    std::optional<double> rate_hz = {};  ///< none: the record states no step
    double start_s = 0.0;
  };
  /// `abscissa`: the first two of an uneven one, or more, in the file's unit. A unit that is not understood may stay so where a
  /// rate is given and the record begins at 0. Throws InputError for another abscissa than even times.
  Times times(const std::string& file, const std::vector<double>& abscissa, std::optional<double> given_hz = {}) const;
};

/// The time responses run by run: a channel (DOF and kind; of other quantities name and unit) that is there already begins the
/// next one. Records with other functions are passed over. Throws InputError for complex values and where there is no time
/// response. What has no direction bears the record's first identification line as name.
std::vector<std::vector<UffChannel>> uff_runs(frf::uff::ByteFile& file);

}  // namespace jointid::records
