#pragma once

#include "frf/set/frf_source.hpp"

namespace jointid::fuzz {

/// Reads FRFs and noise records as the command does: a line at a time, of at most 32 × 32 DOFs.
void read_lines(frf::FrfSource& source);

/// What a user may say of a file with two responses, so that files without DOFs or quantity are read to their end.
frf::OpenOptions two_responses();

}  // namespace jointid::fuzz
