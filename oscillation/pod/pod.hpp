#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "oscillation/pod/record_triangle.hpp"

namespace jointid::oscillation {

struct PodOptions {
  bool remove_mean = true;
  Eigen::MatrixXd mass;  ///< M of the inner product, symmetric positive definite [m, m]; empty: the plain one
};

/// Proper orthogonal decomposition of a record X [T, m] (Kappagantu 2.1–2.14; R = XᵀX/T, the print leaves out 1/T). Modes φ_i
/// with ΦᵀMΦ = I, values λ_i = σ_i²/T: the mean squares of the uncorrelated coordinates a_i = (x − x̄)ᵀMφ_i. By the SVD of the
/// record's triangle times the Cholesky factor of M, not by eigenvectors of R: those lose all σ below 1e-8 σ₁. The values are
/// mean squares, and energies only if M is the mass matrix and the record has velocities. The largest entry of a mode is
/// positive.
struct Pod {
  std::size_t samples = 0, missing = 0;
  Eigen::VectorXd mean;    ///< x̄; zeros where it was not removed
  Eigen::MatrixXd modes;   ///< [m, m]
  Eigen::VectorXd sigma;   ///< descending
  Eigen::VectorXd values;  ///< λ = σ²/T

  /// Σ_{i≤k}σ²/Σσ², k = 1 … m: "energy" in the thesis and here.
  Eigen::VectorXd square_fractions() const;
  /// Σ_{i≤k}σ/Σσ, "energy" elsewhere.
  Eigen::VectorXd sigma_fractions() const;
  /// The smallest number of modes with a square fraction of at least `share` (the thesis: 0.99 in chapter 3, 0.9999 in 5 and 6).
  std::size_t modes_for(double share) const;
};

/// Throws InputError if no sample is complete, or if the mass matrix is not positive definite or has another size.
Pod pod(const RecordTriangle& record, const PodOptions& options = {});
Pod pod(const Eigen::Ref<const Samples>& record, const PodOptions& options = {});

/// a = (X − x̄)MΦ_k of the first `count` modes, [T, count].
Eigen::MatrixXd pod_coordinates(const Pod& pod, const Eigen::Ref<const Samples>& block, std::size_t count,
                                const PodOptions& options = {});

/// Number of σ above white noise of unknown size (Gavish & Donoho 2014, with their cubic for the threshold over the median).
/// Every channel must have the same noise. At least 8 channels, empty otherwise.
std::optional<std::size_t> rank_above_noise(const Pod& pod);

}  // namespace jointid::oscillation
