#pragma once

#include <span>
#include <string>

namespace jointid::records {

/// Samples per second of even times in s (1 % of a step at most off), as the number of six digits next to it where that is nearer
/// than 1e-6. Throws InputError (data) at `place` where times are not even, do not rise, or are less than two.
double rate_of(std::span<const double> times, const std::string& file, const std::string& place);

}  // namespace jointid::records
