#pragma once

#include <filesystem>

#include "tasks/export/joint_for_others.hpp"

namespace jointid::tasks {

/// Of the JSON of `jointid solve`. Standard errors of elements are those of the unknowns that stand there alone by their name:
/// K(1,2) of a joint without a name, K[4:+Y,5:+Y] of any. DOFs have their signs. Throws as exported_joint().
ExportedJoint joint_of_result(const std::filesystem::path& file, std::size_t band);

/// Throws InputError (data) that there are so many bands, or that there is no such one.
[[noreturn]] void refuse_band(const std::filesystem::path& file, std::size_t band, std::size_t count);

}  // namespace jointid::tasks
