#pragma once

#include "frf/csv/csv_columns.hpp"
#include "frf/csv/csv_table.hpp"

namespace jointid::frf {

/// Magnitudes in decibels, v = 20 log10(|H| / reference), become magnitudes where a title, a row of units or `# unit` says of
/// what: "dB re 1 g/N", "dB (re 1e-6 m/N)". Throws InputError naming the column whose decibels have no reference, and parts in
/// decibels; a unit that the user gives (`unit_given`) does not make them numbers of another kind.
void resolve_decibels(CsvTable& table, const CsvColumns& columns, bool unit_given);

}  // namespace jointid::frf
