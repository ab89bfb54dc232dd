#pragma once

#include <filesystem>

#include "ident/result/control.hpp"
#include "tasks/export/joint_for_others.hpp"

namespace jointid::tasks {

/// The joint of a result that `jointid solve --json` wrote (a file that begins with a brace), or of a scene, which is solved.
/// `band`: which of several frequency bands, from 1; 0: there is one. A scene of method "likelihood" gives the covariance of the
/// unknowns (ident::joint_errors()), others and results give variances. Throws InputError (usage) for a band that is not there,
/// and (data) for a joint without usable numbers and a file that is no such result.
ExportedJoint exported_joint(const std::filesystem::path& scene_or_result, std::size_t band = 0,
                             const ident::Control& control = {});

/// Whether a file holds a result in place of a scene: its first character but blanks is a brace.
bool is_result_file(const std::filesystem::path& file);

}  // namespace jointid::tasks
