#pragma once

#include <pybind11/pybind11.h>

#include <filesystem>
#include <string>
#include <vector>

namespace jointid::python {

using Paths = std::vector<std::filesystem::path>;

Paths paths_of(const std::vector<std::string>& names);
std::vector<std::string> names_of(const Paths& paths);

/// A buffer of float64 as numbers of one's own. Throws InputError for one of another kind.
std::vector<double> doubles_of(const pybind11::buffer& buffer);

}  // namespace jointid::python
