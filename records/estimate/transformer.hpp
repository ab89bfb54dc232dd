#pragma once

#include <cstddef>
#include <vector>

#include "records/estimate/fourier.hpp"
#include "records/estimate/frf_options.hpp"

namespace jointid::records {

/// Windows and transforms stretches of one length.
class Transformer {
 public:
  /// `options` must outlive it.
  Transformer(const FrfOptions& options, std::size_t samples, double rate_hz);

  /// The spectrum of a channel in a stretch, N/2 + 1 lines, its mean taken off and windows applied as the options say; its phases
  /// are those of the time since the record's first channel began.
  std::vector<Complex> transform(const Channel& channel, const Blow& blow);

 private:
  void shift(std::vector<Complex>& lines, double start_s) const;

  const FrfOptions& options_;
  double rate_hz_;
  Fourier fourier_;
  std::vector<double> window_;
};

}  // namespace jointid::records
