#pragma once

#include <optional>

#include "impedance/line/line_blocks.hpp"
#include "impedance/line/line_value.hpp"

namespace jointid::impedance {

/// Closed forms of Z at a line, by the numbers of docs/joint-line-by-line.md, each with its covariance to first order:
/// δz = A₁ δH_sub B₁ − A₂ δH_asm B₂, symmetrised (10). Empty where the line lacks an FRF that the form needs. Full forms give Z,
/// upper triangle row by row. Between facing halves Z = T z Tᵀ, and forms with `t` [N × N/2] give z, the same way.
std::optional<LineValue> primal(const LineBlocks& line);                                  ///< (1)
std::optional<LineValue> average(const LineBlocks& line, const Eigen::MatrixXd& t);       ///< (3)
std::optional<LineValue> off_diagonal(const LineBlocks& line, const Eigen::MatrixXd& t);  ///< (2), of the assembly alone
std::optional<LineValue> relative(const LineBlocks& line, const Eigen::MatrixXd& t);      ///< (4)
std::optional<LineValue> extended(const LineBlocks& line);                                ///< (6), R = C = all coordinates
std::optional<LineValue> from_nj(const LineBlocks& line);                                 ///< (7)
std::optional<LineValue> from_nn(const LineBlocks& line, const Eigen::MatrixXd& t);       ///< (8); t = I gives Z

/// The joint's own receptance Y_J = Y_a − Y_a (Y_a − Y_s)⁻¹ Y_a (5), whose inverse is (1); of rank N/2, that is infinite, for a
/// joint without mass between facing halves.
std::optional<Eigen::MatrixXcd> joint_receptance(const LineBlocks& line);

/// Generalised least squares (9): values of `from`, all of a symmetric Z, as a combination of a basis, weighed by their
/// covariance, once; χ² is of what is left. Empty where the covariance is singular.
std::optional<LineValue> weighed(const LineValue& from, const Basis& basis);

/// Largest over smallest singular value.
double condition_of(const Eigen::MatrixXcd& matrix);

}  // namespace jointid::impedance
