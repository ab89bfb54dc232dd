#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <vector>

#include "frf/file/memory_file.hpp"
#include "frf/set/dof.hpp"

namespace jointid::python {

/// The numbers of a dict that dict_of() could have made, as they are, without a copy: buffers of complex128 and float64. Throws
/// InputError for buffers of another kind.
std::shared_ptr<const frf::FrfArrays> arrays_of(const pybind11::dict& of);

/// Of a list of texts.
std::vector<frf::Dof> dofs_of(const pybind11::handle& names);

}  // namespace jointid::python
