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
  frf::Dof dof;
  std::optional<ChannelKind> kind = {};  ///< none: no force or motion of a coordinate
  double to_si = 1.0;
  std::string unit = {};  ///< in SI; of what is no force or motion the file's own, with to_si = 1
  frf::uff::Dataset dataset;

  /// Samples per second; `abscissa`: the first two of an uneven one, or more, in the file's unit. Throws InputError for another
  /// abscissa than even times.
  double rate_hz(const std::string& file, const std::vector<double>& abscissa) const;
};

enum class UffQuantities { forces_and_motions, any };

/// The time responses run by run: a channel (DOF and kind; of other quantities name and unit) that is there already begins the next
/// one. Records with other functions are passed over. Throws InputError for complex values, where there is no time response, and,
/// unless any quantity will do, for a channel that is no force or motion and responses without direction. What has no direction
/// bears the record's first identification line as name.
std::vector<std::vector<UffChannel>> uff_runs(frf::uff::ByteFile& file, UffQuantities quantities);

}  // namespace jointid::records
