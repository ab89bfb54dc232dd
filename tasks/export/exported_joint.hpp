#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ident/result/control.hpp"
#include "ident/result/solution.hpp"

namespace jointid::tasks {

/// A joint as other programs take it. Its DOFs have positive directions: rows and columns of those with a minus sign are turned.
struct ExportedJoint {
  std::string source;          ///< the scene or result that it comes from
  std::string status;          ///< of the identification
  std::vector<frf::Dof> dofs;  ///< N, of positive sign
  ident::Matrices matrices;    ///< K, M, C, D, N×N, SI units; a matrix that the joint does not have is absent
  ident::Matrices errors;      ///< standard errors of their elements; NaN where they are not known, 0 of known elements
  std::vector<ident::Estimate> unknowns;
  ident::Matrix covariance;  ///< of the unknowns, SI units, in their order; NaN where it is not known
};

/// The joint of a result that `jointid solve --json` wrote (a file that begins with a brace), or of a scene, which is solved.
/// `band`: which of several frequency bands, from 1; 0: there is one. A scene of method "likelihood" gives the covariance of the
/// unknowns (ident::joint_errors()), others and results give variances. Throws InputError (usage) for a band that is not there,
/// and (data) for a joint without usable numbers and a file that is no such result.
ExportedJoint exported_joint(const std::filesystem::path& scene_or_result, std::size_t band = 0,
                             const ident::Control& control = {});

/// Whether a file holds a result in place of a scene: its first character but blanks is a brace.
bool is_result_file(const std::filesystem::path& file);

}  // namespace jointid::tasks
