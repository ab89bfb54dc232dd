#pragma once

#include <filesystem>

#include "tasks/response/response_result.hpp"

namespace jointid::report {

/// The lines of response_csv() as a table in HDF5 (frf::TableWriter): force, frequency, harmonic, number of the response (from 1,
/// as in the attribute `dofs`), re, im, deviations of both, error bar of harmonics left out; NaN where nothing is known.
void write_response_table(const std::filesystem::path& path, const tasks::ResponseResult& run);

/// The lines of history_csv(): number of the motion (attribute `motions`), time, responses, motions and forces of the joints.
void write_history_table(const std::filesystem::path& path, const tasks::ResponseResult& run);

/// The lines of curves_csv(): numbers of the curve (attribute `curves`, from 0) and of the place (0 point, 1 turning point, 2
/// peak), parameter, force, frequency, harmonic, number of the response (from 1), re, im, loss, damping (NaN where it is not
/// known).
void write_curves_table(const std::filesystem::path& path, const tasks::ResponseResult& run);

/// Whether the name is that of an HDF5 file.
bool names_hdf5(const std::filesystem::path& path);

}  // namespace jointid::report
