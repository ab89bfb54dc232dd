#pragma once

#include <Eigen/Core>

#include "ident/likelihood/parts/parts_fit.hpp"

namespace jointid::ident {

/// From more unknowns on no matrix of all of them is formed.
inline constexpr std::size_t most_of_dense = 1500;

struct PartsCovariance {
  Eigen::VectorXd variance;  ///< of the scaled unknowns
  Eigen::MatrixXd whole;     ///< empty beyond most_of_dense
};

/// The covariance N⁻¹ G N⁻¹ of the unknowns of a fit. G is that of its gradient: within a group N/2; between two that share motions
///   G_st = ½ Σ Re A_sᴴM_s⁻¹B_s Q_st B_tᴴM_t⁻¹A_t,
/// Q_st the variances of these motions. Errors are circular. Empty where N is not positive definite.
PartsCovariance covariance_by_parts(const Plan& plan, const PartGroups& groups, PartsData& data, const PartsFit& fit, std::size_t threads);

/// N of a fit as a dense matrix.
Eigen::MatrixXd dense_information(const minimise::SparseSymmetric& information);

}  // namespace jointid::ident
