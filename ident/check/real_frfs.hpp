#pragma once

#include <vector>

#include "ident/check/test/checked_file.hpp"

namespace jointid::ident {

/// Files of the assembly whose FRFs are real throughout, where those of a part are not: magnitudes, decibels or one part of
/// complex FRFs. An assembly of damped parts has no real FRFs.
std::vector<Suspect> find_real_assemblies(const std::vector<CheckedFile>& files);

}  // namespace jointid::ident
