#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "frf/hdf5_module/hdf5_object.hpp"

namespace jointid::frf::hdf5 {

/// The texts of an attribute, up to 1024, with commas between them: "N,g"; nothing where it holds no texts.
std::optional<std::string> joined_texts(const Object& object, const char* name);

/// Names and values of the first attributes, up to 100, that are texts (joined_texts()) or up to 64 real numbers; of these the
/// first that is not 1 stands for all of them.
std::vector<std::pair<std::string, std::string>> attributes_as_texts(const Object& object);

/// The names of the datasets that are attached to the axes of a dataset (DIMENSION_LIST), "group.frequency"; empty where an axis has
/// none, nothing where no axis has one.
std::vector<std::string> names_of_scales(const Object& object);

}  // namespace jointid::frf::hdf5
