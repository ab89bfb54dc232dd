#pragma once

#include <filesystem>
#include <utility>
#include <vector>

#include "frf/set/dof.hpp"
#include "scene/reader.hpp"

namespace jointid::models {

/// DOFs of a model and the coordinates (rows of its matrices, from 0) that they are.
struct NamedCoordinates {
  std::vector<frf::Dof> dofs;
  std::vector<std::size_t> coordinates;  ///< as many
};

/// Reads names of the `size` coordinates of a model, as one of
///   - a list of DOFs in the order of the rows, "-" for a coordinate without a name;
///   - a table { "4:+Y" = 7 } of rows, counted from 1;
///   - the name of a file: text with a DOF or "-" a line in the order of the rows, or a row and its DOF a line, comments after #;
///     or "FILE:VARIABLE" of texts in MATLAB or HDF5 (variable `dofs` where none is named).
/// Throws InputError for rows that are not there or lack a name, for a coordinate named twice, and where no coordinate has a name.
NamedCoordinates read_model_dofs(const scene::Item& item, const std::filesystem::path& folder, std::size_t size);

/// Those of `all` that are the coordinates `kept`, in that order and with its signs. Throws InputError that names one which is not
/// there.
NamedCoordinates select(const scene::Item& item, const NamedCoordinates& all, const std::vector<frf::Dof>& kept);

}  // namespace jointid::models
