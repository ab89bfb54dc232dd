#pragma once

#include "frf/uff/uff_catalogue.hpp"

namespace jointid::frf::uff {

/// Finds the coherence record (function type 6) of every FRF, on the same axis, and sets header.noise and header.averages.
/// Coherences are used when every FRF has one; one that stands there twice with the same numbers is one. Averages: the number
/// beside the word "averages" in an ID line of a coherence, else of its FRF, since the format has no field for it; the smallest
/// where they differ, 0 where none says it. What is not used is named in the header's doubts: FRFs without coherence, coherences
/// that differ, multiple coherences (type 26), which say nothing of one of several forces, other numbers of averages.
void attach_coherences(ByteFile& file, Catalogue& catalogue);

}  // namespace jointid::frf::uff
