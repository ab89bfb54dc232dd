#pragma once

#include <Eigen/SparseCore>
#include <optional>

#include "ident/admissible/admissible_set.hpp"

namespace jointid::ident {

/// The point of an AdmissibleSet nearest to an estimate θ̂, in the metric ‖R(θ − θ̂)‖.
struct AdmissibleFit {
  Eigen::VectorXd theta;
  double cost = 0.0;                    ///< ‖R(θ − θ̂)‖²
  double tie_cost = 0.0;                ///< what the ties alone cost of it
  std::vector<double> shares;           ///< per condition, what it costs of the rest; the sum is the rest
  std::vector<Eigen::VectorXd> forces;  ///< per condition, what RᵀR(θ − θ̂) is made of beside the ties; empty: none
  std::vector<Eigen::Index> at_limit;   ///< per condition, how many eigenvalues of S are zero
  Eigen::MatrixXd null_space;  ///< directions that R leaves free where the ties allow them; no columns when there are none
  double condition = 0.0;      ///< of R over what the ties leave
  std::size_t iterations = 0;
  bool converged = true;
};

/// θ̂ itself when it is in the set. `unit` is what ‖R(θ − θ̂)‖ is when θ is a standard deviation off: the result is within
/// about 1e-6 of these of the nearest point, or 1e-6 of its distance where that is more.
AdmissibleFit nearest_admissible(const AdmissibleSet& set, const Eigen::VectorXd& theta, const Eigen::MatrixXd& root,
                                 double unit);

/// The same, without `forces`, in the metric of a sparse N = RᵀR, its lower triangle, of a set without ties: for some 150
/// unknowns and more. Empty where N is not positive definite to rounding, or its iteration did not converge.
std::optional<AdmissibleFit> nearest_admissible(const AdmissibleSet& set, const Eigen::VectorXd& theta,
                                                const Eigen::SparseMatrix<double>& information, double unit);

}  // namespace jointid::ident
