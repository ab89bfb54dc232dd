#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <span>
#include <vector>

#include "frf/file/memory_file.hpp"
#include "frf/set/dof.hpp"

namespace jointid::python {

/// The numbers of a dict that dict_of() could have made, as they are, without a copy: buffers of complex128 and float64. Throws
/// InputError for buffers of another kind.
std::shared_ptr<const frf::FrfArrays> arrays_of(const pybind11::dict& of);

/// The numbers of a buffer of float64 as they are, which live as long as the pointer. Throws InputError for another kind of buffer.
std::shared_ptr<const std::span<const double>> kept_doubles(const pybind11::object& buffer, const char* what);

/// Of a list of texts.
std::vector<frf::Dof> dofs_of(const pybind11::handle& names);

}  // namespace jointid::python
