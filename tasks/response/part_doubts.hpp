#pragma once

#include <string>
#include <vector>

#include "frf/set/frf_system.hpp"
#include "response/structure/frf_receptance.hpp"

namespace jointid::tasks {

/// What the measured parts say against themselves, a phrase each (docs/response.md, "From measured FRFs"): doubts of the reader
/// of a file; FRFs that were measured in both roles and are not those of their transposes; parts that would feed joints and
/// forces with energy, as −Im H of the DOFs that are both has a negative eigenvalue. Beyond what the files' variances explain.
/// Where one sign, a quantity or a gain would put it right, that is said.
std::vector<std::string> part_doubts(const response::FrfReceptance& measured, const frf::FrfSystem& parts);

}  // namespace jointid::tasks
