#pragma once

#include <optional>
#include <string_view>

#include "frf/set/quantity.hpp"
#include "frf/set/unit_label.hpp"
#include "frf/uff/uff58_header.hpp"

namespace jointid::frf::uff {

/// Dataset 164: a number in the file's units is the SI number times the factor, so SI = number / factor.
struct UnitFactors {
  double length = 1.0;
  double force = 1.0;
};

/// frf::parse_unit() of a label in Latin-1 or UTF-8, blanks around it left out.
std::optional<Unit> parse_label(std::string_view label);

/// What the values of an FRF record are and the factor that brings them to SI.
struct Ordinate {
  Quantity quantity = Quantity::receptance;
  double to_si = 1.0;
  std::optional<Quantity> stated{};  ///< by the record itself
};

/// Interprets records 9 and 10 of an FRF.
///
/// Quantity: data type 8, 11 or 12 over 13; with a type 0 or 1 on either side it comes from `given`. A unit
/// label whose dimension is another quantity's contradicts the types; `given` then decides, without it this
/// is an error. A `given` decides even where the record states another; a label of another dimension is then not used.
///
/// Units, for numerator and denominator separately: the record's unit label if its dimension fits; otherwise
/// dataset 164 (`factors`); never both. A label of record 9 that is a motion over a force, such as (m/s^2)/N,
/// settles both. A label that is not understood counts as none.
Ordinate interpret_ordinate(const Header58& header, const UnitFactors& factors, std::optional<Quantity> given,
                            const Place& place);

/// Whether a spectrum is one of forces: by data type 13 of record 9; of an unknown type (0 or 1) by its unit; empty when neither says it.
std::optional<bool> spectrum_of_forces(const Header58& header);

/// Interprets record 9 of a spectrum, whose denominator says nothing: motions as numerators of FRFs; a force (moment) becomes N (N·m) by
/// its unit label, else by dataset 164, and is called a receptance.
Ordinate interpret_spectrum(const Header58& header, const UnitFactors& factors, std::optional<Quantity> given, const Place& place);

/// Factor to Hz of the abscissa: label Hz or none 1, kHz 1000, rad/s 1/2π. Throws InputError when record 8
/// says that the abscissa is no frequency (a type other than 18, 0 and 1).
double abscissa_to_hz(const Header58& header, const Place& place);

}  // namespace jointid::frf::uff
