#pragma once

#include <string_view>
#include <vector>

#include "ident/check/test/checked_file.hpp"

namespace jointid::ident {

/// Files of the assembly whose FRFs are real throughout, where those of a part are not: magnitudes, decibels or one part of
/// complex FRFs. An assembly of damped parts has no real FRFs.
std::vector<Suspect> find_real_assemblies(const std::vector<CheckedFile>& files);

/// A note where neither the parts nor the assembly have an imaginary part: a model without damping has none, and no magnitude has
/// one.
inline constexpr std::string_view all_frfs_are_real =
    "All imaginary parts are 0, of parts and assembly: FRFs of models without damping, or magnitudes? Of measured FRFs export "
    "real and "
    "imaginary parts.";
bool are_all_real(const std::vector<CheckedFile>& files);

}  // namespace jointid::ident
