#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "series/pod/record_triangle.hpp"

namespace jointid::series {

struct PodOptions {
  bool remove_mean = true;
  Eigen::MatrixXd mass;  ///< M of the inner product, symmetric positive definite [m, m]; empty: the plain one
};

/// Proper orthogonal decomposition of a record X [T, m] (Kappagantu 2.1–2.14; R = XᵀX/T, whose 1/T the print leaves out): modes
/// φ_i with ΦᵀMΦ = I and values λ_i = σ_i²/T, the mean squares of the coordinates a_i = (x − x̄)ᵀMφ_i, which are uncorrelated. By
/// the SVD of the record's triangle times the Cholesky factor of M, never by eigenvectors of R: those lose all σ below 1e-8 σ₁.
/// The values are mean squares, an energy only where M is the mass matrix and the record velocities. The largest entry of a mode
/// is positive.
struct Pod {
  std::size_t samples = 0, missing = 0;
  Eigen::VectorXd mean;    ///< x̄; zeros where it was not removed
  Eigen::MatrixXd modes;   ///< [m, m]
  Eigen::VectorXd sigma;   ///< descending
  Eigen::VectorXd values;  ///< λ = σ²/T

  /// Σ_{i≤k}σ²/Σσ², k = 1 … m: what "energy" means in the thesis and here.
  Eigen::VectorXd square_fractions() const;
  /// Σ_{i≤k}σ/Σσ, which others call energy.
  Eigen::VectorXd sigma_fractions() const;
  /// The smallest number of modes with a square fraction of at least `share` (the thesis: 0.99 in chapter 3, 0.9999 in 5 and 6).
  std::size_t modes_for(double share) const;
};

/// Throws InputError where no sample is whole or the mass matrix is not positive definite or of another size.
Pod pod(const RecordTriangle& record, const PodOptions& options = {});
Pod pod(const Eigen::Ref<const Samples>& record, const PodOptions& options = {});

/// a = (X − x̄)MΦ_k of the first `count` modes, [T, count].
Eigen::MatrixXd pod_coordinates(const Pod& pod, const Eigen::Ref<const Samples>& block, std::size_t count,
                                const PodOptions& options = {});

/// How many σ stand above white noise of unknown size (Gavish & Donoho 2014, with their cubic for the threshold over the median),
/// of records with as much noise on every channel; at least 8 channels, empty otherwise.
std::optional<std::size_t> rank_above_noise(const Pod& pod);

}  // namespace jointid::series
