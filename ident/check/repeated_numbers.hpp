#pragma once

#include <vector>

#include "ident/check/test/checked_file.hpp"

namespace jointid::ident {

/// Runs of one measurement that are the same numbers (`repeats` of the scene): whoever exported them took one file twice. A few
/// lines of each are read.
std::vector<Suspect> find_equal_runs(const Scene& scene);

/// References whose FRFs are those of another, and single FRFs that are those of another response to the same reference, number
/// by number, beside others that differ. FRFs without any noise of their own say nothing: symmetry makes them equal (noise is
/// recorded, or H_ij and H_ji differ by more than rounding).
std::vector<Suspect> find_copied_columns(const CheckedFile& file);

}  // namespace jointid::ident
