#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <cstddef>
#include <vector>

#include "modalfit/model/shape_covariance.hpp"

namespace jointid::modalfit {

/// Residual terms of one FRF, SI: −L/ω² + U, and the covariance of (Re L, Im L, Re U, Im U), [4,4].
struct ResidualTerms {
  std::complex<double> lower, upper;
  std::array<double, 16> covariance{};
  bool measured = false;  ///< false: completed from the measured ones
};

/// Residual terms of a symmetric matrix of FRFs over n coordinates, measured between the core (k of them) and all; memory n·k.
/// Between coordinates c, d of which neither FRF was measured they are completed from the columns r of the core that were measured to all
/// coordinates: U_cd = U_cr (U_rr)⁺ U_rd (Nyström), which is exact where the rank of U does not exceed that of U_rr, as of
/// rigid-body modes, and too small otherwise; 0 where no column was.
class ResidualTable {
 public:
  ResidualTable() = default;
  explicit ResidualTable(Core core) : core_(std::move(core)), terms_(core_.size() * core_.count) {}

  /// Keeps the mean of both where (a,b) and (b,a) were measured. One of the two is of the core.
  void put(std::size_t a, std::size_t b, const ResidualTerms& terms);
  /// Prepares what completes; after the last put().
  void complete();
  ResidualTerms between(std::size_t a, std::size_t b) const;
  /// Terms kept: n·k.
  std::size_t size() const { return terms_.size(); }
  /// Of FRFs times a factor.
  void multiply(double factor);

 private:
  /// X_nr and (X_rr)⁺ X_rn of the lower or the upper residuals.
  struct Completion {
    Eigen::MatrixXcd tall, wide;
  };
  std::size_t index(std::size_t a, std::size_t core) const { return a * core_.count + core_.place[core]; }
  std::vector<std::size_t> complete_columns() const;
  Completion completion(std::complex<double> ResidualTerms::*term) const;

  Core core_;
  std::vector<ResidualTerms> terms_;  ///< [n,k]
  std::vector<std::size_t> columns_;  ///< coordinates that complete
  Completion lower_, upper_;
};

}  // namespace jointid::modalfit
