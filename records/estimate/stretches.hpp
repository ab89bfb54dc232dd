#pragma once

#include <span>
#include <vector>

#include "records/estimate/frf_options.hpp"

namespace jointid::records {

/// The blows or segments of all records in their order; those that the options or their faults leave out say why. Throws
/// InputError for a block that no record holds and for numbers to reject that there are not.
std::vector<Blow> find_stretches(std::span<const Record> records, const FrfOptions& options);

}  // namespace jointid::records
