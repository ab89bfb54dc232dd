#pragma once

#include <filesystem>
#include <memory>

#include "frf/set/frf_source.hpp"

namespace jointid::frf {

/// Opens a MATLAB file and loads its FRFs whole. Variables, by name (case does not matter, but for single
/// letters):
///   - the FRFs: OpenOptions::variable, or `frf`, or else the only complex array with an axis as long as the
///   frequencies:
///     [F], [F,N], [R,C,F] or [F,R,C] with N = R·C columns, column r + R·c for response r and reference c;
///     real arrays only by name;
///   - frequency_hz, frequency, freq, f, freq_hz, frequencies, freq_domain (Hz), or w, omega (rad/s);
///   - response_dof, reference_dof: text, cell array of texts or rows of characters; else
///   OpenOptions::response and
///     reference (default: the responses when the matrix is square);
///   - quantity, else OpenOptions::quantity; unit, else SI;
///   - axes: 'FRC' or 'RCF', for matrices whose sizes leave that open;
///   - variance, or coherence (with the number averages, if known), shaped as the FRFs.
/// Throws InputError naming the variable, and all candidates where there are several.
std::unique_ptr<FrfSource> open_mat_v73(const std::filesystem::path& path, const OpenOptions& options = {});

/// The same of MATLAB v4 to v7 files. A build without matio throws InputError for v5 and later.
std::unique_ptr<FrfSource> open_mat_v5(const std::filesystem::path& path, const OpenOptions& options = {});

/// Writes a v5 file with frequency [F,1], frf [F,R,C] in header.quantity and SI units, axes,
/// response_dof, reference_dof, quantity, unit and the noise record; nodes are not part of it.
void write_mat(const FrfSet& set, const std::filesystem::path& path);

}  // namespace jointid::frf
