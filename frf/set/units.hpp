#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "frf/set/frf_set.hpp"
#include "frf/set/quantity.hpp"

namespace jointid::frf {

/// Factor that turns an FRF labelled `unit_label` into SI units, e.g. 1e-3 for "mm/N" and 9.80665 for "g/N".
/// A label is a product of units with exponents, as parse_unit() reads them: "m/s^2/N", "(mm/s²)/N", "m/(s^2*N)", "rad/(N*m)", "1/kg".
/// Motion may be a length or an angle, force a force or a moment. Throws InputError (data) naming the label when it does not parse,
/// with what unit_hint() knows of it, or is no unit of `quantity`.
double si_factor(std::string_view unit_label, Quantity quantity);

/// The same for the label of a whole set. One label cannot scale translations and rotations alike (mm/N says nothing
/// of rad/N), so a set with rotations must be in SI units; otherwise throws InputError.
double si_factor(std::string_view unit_label, const FrfHeader& header);

/// The same for the label of one FRF, that of response `r` to reference `c`: of a rotation an angle, over a force or a moment. Throws
/// InputError where the label is of a translation and the response is a rotation, or the other way, and so for forces and moments.
double si_factor(std::string_view unit_label, const FrfHeader& header, std::size_t r, std::size_t c);

/// The SI unit of an FRF: "rad/s^2/N" of the accelerance of a rotation to a force.
std::string si_unit(Quantity quantity, const Dof& response, const Dof& reference);

/// The quantity that a label is a unit of: accelerance of "g/N"; empty where it is none of an FRF, or not understood.
std::optional<Quantity> quantity_of_unit(std::string_view unit_label);

/// Throws InputError (data) unless the label is a motion over a force or moment, of any quantity.
void require_frf_unit(std::string_view unit_label);

}  // namespace jointid::frf
