#pragma once

#include <cstddef>
#include <vector>

#include "modalfit/band/band.hpp"
#include "modalfit/band/model_kind.hpp"
#include "modalfit/band/pole.hpp"

namespace jointid::modalfit {

/// Coefficients of Basis for some FRFs, each by weighted linear least squares with the poles as they are.
struct Residues {
  std::size_t columns = 0;
  double unit = 1.0;  ///< receptance, m/N, of a coefficient of 1
  std::vector<double> coefficients;  ///< [entry, column]
  std::vector<double> variance;      ///< [entry, column] in unit², with that of the poles where their covariance was given
  std::vector<double> cost;          ///< [entry] Σ|residual|²/σ²
  std::vector<double> bounded_cost;  ///< [entry] the same with no part of a line counted above 9: what a few lines cannot spoil
  std::vector<double> freedom;       ///< [entry] equations minus columns, 0 where nothing was measured
  /// [mode] by how much Σcost would grow if the mode were left out (Wald): Σ_e cᵀ(cov c)⁻¹c over its coefficients.
  std::vector<double> growth;
};

/// `pole_covariance`: [2N,2N] of (ln f, damping) as refine() gives it, or empty for exact poles.
Residues fit_residues(const Band& band, const std::vector<std::size_t>& entries, const ModelKind& kind, const std::vector<Pole>& poles,
                      const std::vector<double>& pole_covariance = {});

}  // namespace jointid::modalfit
