#pragma once

#include <memory>
#include <vector>

#include "frf/frf_source.hpp"
#include "ident/scene.hpp"

namespace jointid::ident {

/// Opens the files of a system (headers only), repeats as their mean. Throws InputError as frf::open() and
/// frf::mean_of_repeats().
std::vector<std::unique_ptr<frf::FrfSource>> open_all(const std::vector<DataFile>& files);

}  // namespace jointid::ident
