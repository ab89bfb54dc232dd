#pragma once

#include <memory>
#include <vector>

#include "frf/set/frf_source.hpp"
#include "frf/set/sensor_mass.hpp"

namespace jointid::frf {

/// The FRFs of a source without the masses that the structure carried in the test; see corrected().
std::unique_ptr<FrfSource> unloaded_source(std::unique_ptr<FrfSource> source, const std::vector<DofNumber>& masses, SensorsOn sensors);

}  // namespace jointid::frf
