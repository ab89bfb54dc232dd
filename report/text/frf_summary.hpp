#pragma once

#include <string>

#include "tasks/convert/frf_census.hpp"

namespace jointid::report {

/// Header and census for reading; the first of the values that stand out one by one.
std::string summary_text(const frf::FrfHeader& header, const tasks::FrfCensus& census);

}  // namespace jointid::report
