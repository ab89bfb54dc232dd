#pragma once

#include <filesystem>
#include <memory>
#include <span>

#include "frf/set/frf_source.hpp"

namespace jointid::frf {

/// Whether the beginning of a file can be a table of text: no binary bytes, and a separator in the first line
/// that is neither blank nor a comment.
bool looks_like_csv(std::span<const char> head);

/// Whether a row of titles in the beginning of a file names the DOFs of FRFs as a table does, "12:+X/…".
bool names_frfs(std::span<const char> head);

/// Opens a table of FRFs and loads it whole. Layout:
///
///     # quantity = accelerance        optional; else OpenOptions::quantity
///     # unit = m/(s^2*N)              optional; default the SI unit of the quantity; or in the titles, "4:+Y/1:+Y re [g/N]", or in a
///                                     row under them
///     # averages = 10                 with coherence columns, if known
///     # node 4 = 0.5 0 0              position of a node in m, optional
///     frequency_hz, 4:+Y/1:+Y re, 4:+Y/1:+Y im, 5:+Y/1:+Y mag, 5:+Y/1:+Y phase_deg, …
///     10.0, 1.2e-6, -3.4e-8, …
///
/// A column is `response/reference part`, part one of re, im, mag, phase_deg, var_re, var_im, coherence, in
/// any order. Without `response/reference`, columns are taken for OpenOptions::response × reference, row by
/// row, each pair in turn (reference default: the responses when there are as many pairs). Separator: comma,
/// semicolon or tab, the latter two with decimal points or commas (read_csv_table()). An empty cell, NaN or a pair without a
/// column is not measured. Throws InputError naming line and column.
std::unique_ptr<FrfSource> open_csv(const std::filesystem::path& path, const OpenOptions& options = {});

/// Writes a set in that layout, in header.quantity and SI units, all digits.
void write_csv(const FrfSet& set, const std::filesystem::path& path);

}  // namespace jointid::frf
