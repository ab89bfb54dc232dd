#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "ident/plan/plan.hpp"
#include "ident/result/control.hpp"

namespace jointid::ident {

/// The equations of Method One at one line, A Z_j B = C, and E|δ|² of the measured FRFs in them, (m/N)². NaN: not measured.
struct NoisyLine {
  double frequency_hz = 0.0;
  Eigen::MatrixXcd a, b, c;  ///< [M×N], [N×L], [M×L]
  Eigen::MatrixXd a_variance, b_variance;
  Eigen::MatrixXd c_variance;  ///< of the FRFs of C that are not elements of A or B as well, nor in part_errors
  /// Of each column, where the substructures' file has covariances: F of the covariance F Fᴴ of the column's FRFs, those of B and then
  /// those of C's rows that are no joint coordinates. Else empty.
  std::vector<Eigen::MatrixXcd> part_errors;
};

/// Some lines of a plan with what is known of their noise.
struct NoisyLines {
  std::vector<NoisyLine> lines;
  /// The joint coordinate of a row of A (a column of B), or −1: there C has the elements of B (of A) with it.
  std::vector<Eigen::Index> row_joint, column_joint;
  bool wanted[2][2] = {};  ///< [joint row][joint column]: the named equations
  Dofs rows, columns;
  /// Whether all variances are those of files or of [noise]; else some are upper bounds from the scatter between lines.
  bool from_knowledge = true;

  bool is_wanted(Eigen::Index row, Eigen::Index column) const {
    return wanted[row_joint[static_cast<std::size_t>(row)] >= 0][column_joint[static_cast<std::size_t>(column)] >= 0];
  }
};

/// Reads up to `most` lines of a plan, spread over all of them, in the form of Method One: by the plan's equations, or for
/// methods that have others by all that the data allow. Empty where Method One has no equation, or nothing is known of the
/// noise: files without variances and no [noise], whose lines are too coarse to tell noise from what is between them.
std::optional<NoisyLines> read_noisy_lines(const Plan& plan, std::size_t most);

}  // namespace jointid::ident
