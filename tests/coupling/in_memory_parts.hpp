#pragma once

#include "coupling/assembly_reader.hpp"
#include "problems/structure/structure.hpp"

namespace jointid::coupling {

/// A set as a part.
Part part_of(const std::string& name, frf::FrfSet set, bool reciprocity = false);

/// All receptances of a structure on some lines.
frf::FrfSet receptances(const problems::Structure& structure, const std::vector<double>& frequency_hz);

/// Everything that a reader has.
frf::FrfSet read_all(AssemblyReader& reader);
frf::FrfSet couple_all(const std::vector<Part>& parts, const Assembly& assembly, const Options& options = {});

/// The largest difference of two sets, whose DOFs `names` of `found` are `expected`'s in order, relative to the largest FRF of the line.
double largest_difference(const frf::FrfSet& found, const std::vector<frf::Dof>& names, const frf::FrfSet& expected);

/// "k:+Y"
frf::Dof y(std::int64_t node, int sign = +1);
PlacedDof placed(const std::string& text);

}  // namespace jointid::coupling
