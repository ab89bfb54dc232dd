#pragma once

#include <memory>
#include <vector>

#include "frf/set/frf_source.hpp"
#include "ident/scene/scene.hpp"

namespace jointid::ident {

/// Opens the files of a system (headers only), with the corrections and virtual points of the scene, repeats as their mean. Throws
/// InputError as frf::open(), frf::corrected(), virtualpoint::virtual_source() and frf::mean_of_repeats().
std::vector<std::unique_ptr<frf::FrfSource>> open_all(const std::vector<DataFile>& files);

}  // namespace jointid::ident
