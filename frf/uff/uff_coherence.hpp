#pragma once

#include "frf/uff/uff_catalogue.hpp"

namespace jointid::frf::uff {

/// Finds the coherence record of every FRF and sets header.noise and header.averages by the rule of
/// build_catalogue.
void attach_coherences(ByteFile& file, Catalogue& catalogue);

}  // namespace jointid::frf::uff
