#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "records/file/record.hpp"

namespace jointid::records {

/// A stretch of a record and the phase of what its force does first there, φ(τ) = phase + ωτ + ½ατ², τ from its middle.
struct OrderStretch {
  double middle_s = 0.0;  ///< from the first sample of the record
  double length_s = 0.0;
  double phase = 0.0;  ///< rad
  double omega = 0.0;  ///< rad/s
  double rate = 0.0;   ///< α, rad/s²

  double periods() const { return omega * length_s / 6.283185307179586; }
};

/// x(τ) = Re Σ_n (X_n + X′_n s + X″_n s²) e^{inφ(τ)} + the mean, s = τ over half the length: orders of all channels in one
/// stretch.
struct OrderFit {
  Eigen::MatrixXcd value, slope, bend;  ///< X_n, X′_n, X″_n, [harmonic, channel]; 0 where the degree does not have them
  /// Of Re X_n and Im X_n each, [harmonic, channel]: from what is left of the channel at orders near n, between those of the fit.
  Eigen::MatrixXd deviation;
  double slope_deviation = 1.0;  ///< of X′_n in parts of that of X_n
  Eigen::MatrixXd freedom;       ///< numbers that each deviation comes from
  Eigen::VectorXd explained;     ///< of each channel what part of its variance the orders are
};

/// Least squares over the samples of the stretch (those whose τ is within it), orders 0 … the largest harmonic + 1, amplitudes of
/// that degree (0 to 2). Throws InputError (data) where the stretch has less than 8 periods or an order is above 0.45 of the
/// rate. Deviations cost more than all else: without them they are 0.
enum class NoiseOfOrders { told, left_out };
OrderFit fit_orders(const Record& record, const OrderStretch& stretch, const std::vector<int>& harmonics, int degree,
                    NoiseOfOrders noise = NoiseOfOrders::told);

/// The stretch must lie in the record: its first sample and how many.
std::size_t first_sample(const Record& record, const OrderStretch& stretch);
std::size_t sample_count(const Record& record, const OrderStretch& stretch);

}  // namespace jointid::records
