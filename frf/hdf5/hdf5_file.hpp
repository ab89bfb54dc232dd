#pragma once

#include <filesystem>
#include <memory>

#include "frf/set/frf_source.hpp"

namespace jointid::frf {

/// Whether an HDF5 file carries the root attribute `format`, as every jointid-frf file does.
bool has_format_attribute(const std::filesystem::path& path);

/// Opens a file of the layout jointid-frf version 1 or 2: reads and checks all but FRFs, variances, coherences and covariances,
/// which are read line by line when asked for. Root attributes format = "jointid-frf", version = 1 or 2; datasets
/// frequency [F] (Hz), response_dof [R], reference_dof [C] (text), frf [F,R,C] ({r,i}, attributes quantity
/// and unit), optional variance [F,R,C] ({r,i}: variances of the real and the imaginary part of frf, its unit
/// squared) or coherence [F,R,C] (attribute averages, if known), in version 2 beside variance an optional covariance
/// [F,R(R+1)/2,C] ({r,i}: FrfSet::covariance in the unit of frf squared) or covariance_factor [F,R·K,C] ({r,i}: row r·K + k is column k of
/// L at response r, Σ = L Lᴴ + diag(d)) with an optional covariance_diagonal [F,R,C] (d), optional node_id [P] and node_position [P,3] (m).
/// Throws InputError naming the dataset or attribute that breaks the layout.
std::unique_ptr<FrfSource> open_hdf5(const std::filesystem::path& path);

}  // namespace jointid::frf
