#pragma once

#include <filesystem>
#include <vector>

#include "frf/uff/uff55.hpp"

namespace jointid::tasks {

/// The modes of what `jointid modalfit --json` wrote: frequency, damping and shape, all digits of it. Throws InputError (data) with the
/// key that is missing or not as it should be.
std::vector<frf::Uff55Mode> modes_of_result(const std::filesystem::path& file);

}  // namespace jointid::tasks
