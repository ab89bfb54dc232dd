#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "frf/set/quantity.hpp"
#include "frf/set/unit_label.hpp"
#include "frf/uff/uff58_header.hpp"

namespace jointid::frf::uff {

/// Dataset 164: a number in the file's units is the SI number times the factor, so SI = number / factor.
struct UnitFactors {
  double length = 1.0;
  double force = 1.0;
  std::string contradiction{};  ///< what its units code says otherwise; empty: nothing
};

/// What the user says of the FRFs of a file: their quantity, and their unit in place of all labels; empty: nothing.
struct GivenUnits {
  std::optional<Quantity> quantity;
  std::string unit;
};

/// What the values of an FRF record are and the factor that brings them to SI.
struct Ordinate {
  Quantity quantity = Quantity::receptance;
  double to_si = 1.0;
  std::optional<Quantity> stated{};  ///< by the record itself
};

/// Whether a record of function type 4 relates a motion to a force, or does not say what it relates. False for microphones,
/// strain gauges, temperatures, by their data types or, of types 0 and 1, by their unit.
bool may_be_motion_over_force(const Header58& header);

/// "pressure / excitation force" of records 9 and 10, by their data types; the numerator alone when record 10 is not used.
std::string quantity_in_words(const Header58& header);

/// Interprets records 9 and 10 of an FRF.
///
/// Quantity: data type 8, 11 or 12 over 13; with a type 0 or 1 on either side it comes from `given`, or from the unit labels
/// where they say motion and force. A unit label whose dimension is another quantity's contradicts the types; `given` then
/// decides, without it this is an error. A `given` decides even where the record states another; a numerator's label of another
/// dimension is then not used, and an error where it is no SI unit (nobody then knows in which unit the numbers are). The label
/// of the force holds all the same.
///
/// Units, for numerator and denominator separately: the record's unit label; where it is blank or NONE, dataset 164 (`factors`);
/// never both. A label of record 9 that is a motion over a force, such as (m/s^2)/N, settles both. Throws InputError at record 9
/// or 10 for a label that is not understood, is no motion or force, or cannot belong to the other one ("g rms" over "N pk"). At a
/// rotation a label of the translation in SI units ("N" for N·m) counts as none. `given.unit` stands in place of both labels.
Ordinate interpret_ordinate(const Header58& header, const UnitFactors& factors, const GivenUnits& given, const Place& place);

/// Whether a spectrum is one of forces: by data type 13 of record 9; of an unknown type (0 or 1) by its unit; empty when neither says it.
std::optional<bool> spectrum_of_forces(const Header58& header);

/// Interprets record 9 of a spectrum, whose denominator says nothing: motions as numerators of FRFs; a force (moment) becomes N
/// (N·m) by its unit label, else by dataset 164, and is called a receptance. Throws InputError for labels as
/// interpret_ordinate(), and where a unit is given, which is one of FRFs.
Ordinate interpret_spectrum(const Header58& header, const UnitFactors& factors, const GivenUnits& given, const Place& place);

/// Factor to Hz of the abscissa by its label, hertz_per(); 1 without one. Throws InputError at record 8 for a label that is not
/// understood, and when the record says that the abscissa is no frequency (a type other than 18, 0 and 1).
double abscissa_to_hz(const Header58& header, const Place& place);

}  // namespace jointid::frf::uff
