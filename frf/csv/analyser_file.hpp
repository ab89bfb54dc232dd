#pragma once

#include <filesystem>
#include <memory>
#include <span>

#include "frf/set/frf_source.hpp"

namespace jointid::frf {

/// Whether the beginning of a file is that of an analyser's text export: lines of labels, then a row of tab-separated headings
/// that begins with Frequency and has Real in it.
bool looks_like_analyser_text(std::span<const char> head);

/// Opens the text export of an analyser and loads it whole. Latin-1 or UTF-8, lines ended by LF or CR/LF, cells separated by
/// tabs, numbers with decimal point or comma. Layout, for one or more FRFs side by side:
///
///     Units: Ratio
///     Ref Chan:Resp Chan ⇥ 1+Z:4-Z        reference:response, node and direction; or Resp Chan:Ref Chan
///     …                                   other labels: units and factors that they state (read_csv_notes())
///     Frequency ⇥ Real ⇥ Imaginary        a pair of columns per FRF
///     Units:
///     Hz ⇥ (m/s²)(N) ⇥                    of the frequencies; motion over force, (A)(B) meaning A/B; tells the quantity
///     0.0 ⇥ -0.16 ⇥ 0
///
/// The DOFs of OpenOptions come first: as many responses × references as FRFs, row by row. Without a unit OpenOptions::quantity
/// in SI units is taken; OpenOptions::unit stands in place of all units. Throws InputError naming the line of what does not fit.
std::unique_ptr<FrfSource> open_analyser_text(const std::filesystem::path& path, const OpenOptions& options = {});

}  // namespace jointid::frf
