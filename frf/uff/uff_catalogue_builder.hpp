#pragma once

#include "frf/set/frf_source.hpp"
#include "frf/uff/uff_catalogue.hpp"

namespace jointid::frf::uff {

/// Builds the grid from the headers of all records of function type 4 that are motions over forces, complex, with DOFs (their own
/// or given ones, give_dofs()); others, of microphones or strain gauges, are named in the header's doubts. Where there are none
/// and `options.spectra` asks for it, from the spectra of motions or of forces, all over the one reference 0:+X, which a spectrum
/// does not have.
///
/// Axis: that of the first FRF record, in Hz; every other FRF record must have as many points, each at less
/// than 0.1 of a line spacing from it (even records here, uneven ones when they are read). DOFs come in the
/// order of first appearance with the sign they then have; factors of records with the opposite sign are
/// negative. Noise: attach_coherences().
Catalogue build_catalogue(ByteFile& file, const OpenOptions& options);

}  // namespace jointid::frf::uff
