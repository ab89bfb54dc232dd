#pragma once

#include <string>
#include <vector>

#include "report/export/export_options.hpp"
#include "tasks/export/joint_for_others.hpp"

namespace jointid::report {

/// "nastran", "ansys", "abaqus", "matrix-market"; "auto", "springs", "bush", "matrix". Throw InputError (usage) with the nearest
/// word.
ExportTarget parse_export_target(const std::string& word);
ExportWay parse_export_way(const std::string& word);

/// The endings of all files that export_files() may make.
std::vector<std::string> export_suffixes(const ExportOptions& options);

/// The joint as cards of a finite-element program, with the standard error of each value in a comment beside it, the covariance
/// of the unknowns as CSV (SI units), and for Matrix Market the DOFs as CSV. Values have at least ten digits. The first file is
/// the one to include.
///
///     Z(ω) = K − ω²M + i(ωC + D)
///
/// Throws InputError (usage) for what the program's elements do not hold: unsymmetric matrices outside of Nastran, Abaqus and
/// Matrix Market, springs and bushes for what are none.
std::vector<ExportFile> export_files(const tasks::ExportedJoint& joint, const ExportOptions& options);

}  // namespace jointid::report
