#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "ident/plan/plan.hpp"

namespace jointid::ident {

/// A motion in which a joint matrix gives energy away: an eigenvalue of its symmetric part, with rows and columns scaled to unit
/// diagonal, that is negative beyond its error and by more than a twentieth of the largest one.
struct ActiveMotion {
  restrictions::Kind kind = restrictions::Kind::stiffness;
  std::optional<Range> band_hz;
  double eigenvalue = 0.0;  ///< in parts of the largest one's size
  double deviation = 0.0;   ///< its standard deviation, in the same
  frf::Dof most_moved;      ///< the joint coordinate with the largest share in it
};

/// Negative eigenvalues of K, C and D beyond `deviations` standard deviations, worst first. `theta` are the scaled unknowns and
/// `covariance` is theirs: the deviation of vᵀXv for the eigenvector v of X(theta), to first order.
std::vector<ActiveMotion> active_motions(const Plan& plan, const std::vector<double>& theta, const Eigen::MatrixXd& covariance,
                                         double deviations);

/// A diagonal element of K, C or D that is negative beyond its error: no passive joint has one, whatever else it couples.
struct NegativeDiagonal {
  restrictions::Kind kind = restrictions::Kind::stiffness;
  std::optional<Range> band_hz;
  frf::Dof dof;
  double value = 0.0, deviation = 0.0;  ///< SI
};

/// Those that are more than `deviations` standard deviations below zero, most certain first.
std::vector<NegativeDiagonal> negative_diagonals(const Plan& plan, const std::vector<double>& theta,
                                                 const Eigen::MatrixXd& covariance, double deviations);

/// A matrix with an eigenvalue that is negative by much of the largest.
struct Indefinite {
  restrictions::Kind kind = restrictions::Kind::stiffness;
  std::optional<Range> band_hz;
  double share = 0.0;  ///< the eigenvalue over the size of the largest
};

/// Those of K, C and D whose smallest eigenvalue is below −`share` of the largest size, worst first. Translations and rotations are each
/// scaled by the largest element of their own. Where the joint is passive the error of such a matrix is at least that large.
std::vector<Indefinite> indefinite_matrices(const Plan& plan, const std::vector<double>& theta, double share);

/// "hysteretic damping D".
std::string of_matrix(restrictions::Kind kind);

/// "hysteretic damping D has a negative eigenvalue, -0.83 ± 0.02 of its largest, with most motion at 4:+Y".
std::string text(const ActiveMotion& motion);

/// "stiffness K is negative at 4:+Y, -1.6e+06 ± 3e+05".
std::string text(const NegativeDiagonal& element);

}  // namespace jointid::ident
