#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "records/file/record.hpp"

namespace jointid::records {

/// How phasors are taken of records.
struct OrderOptions {
  std::vector<int> harmonics{1};         ///< n ≥ 1, ascending
  double settle_s = 0.0;                 ///< left out at the start
  std::optional<double> frequency_hz{};  ///< of the force of a steady record as it was set; else found
  int periods = 20;                      ///< of a window of a sweep
};

/// Phasors of all channels at one frequency of the force, x = Re Σ X_n e^{inωt}, peak values in the channels' SI units with the
/// signs of the sensors. The phase of all is that of the force's first zero crossings.
struct OrderPhasors {
  double frequency_hz = 0.0;
  double periods = 0.0;    ///< of the window
  Eigen::MatrixXcd value;  ///< [harmonic, channel]
  /// Of Re and Im each, [harmonic, channel], from the channel's noise at orders beside n; made larger by √(ν/(ν − 2)), ν numbers
  /// having told it, so that sums of squares in deviations are their freedom in the mean.
  Eigen::MatrixXd deviation;
  double window_bias = 0.0;  ///< of a sweep: by what part of |X₁| a window half as long differs, the largest of all motions
  double lag_bias = 0.0;  ///< by what part of |X₁| the steady response differs, |X₁″|/2α: the sweep is not infinitely slow
};

/// Throws InputError (data) for a channel with missing samples, one that does not change, and one that is clipped: more of its
/// samples equal the largest or smallest than a sine of its resolution has.
void require_sound(const Record& record);

/// Of a record of steady vibration under one force frequency: least squares over whole periods, all of the record in one window,
/// whose amplitudes are constant (no bias of a window). Throws InputError (data) for unsound channels, a record of less than 8
/// periods, a force that is no sine, one whose frequency is 1e-3 from the one set, and a motion whose amplitude goes up or down
/// by 5 % (and 5 of its deviations) from end to end.
OrderPhasors steady_phasors(const Record& record, const OrderOptions& options);

/// Of a record of one slow sweep up or down: at each of these frequencies that it passes with room for a window, orders of the
/// force's phase with amplitudes quadratic in time. Throws InputError (data) for unsound channels, a force that does not sweep,
/// or sweeps more than once.
std::vector<OrderPhasors> sweep_phasors(const Record& record, const std::vector<double>& lines_hz, const OrderOptions& options);

}  // namespace jointid::records
