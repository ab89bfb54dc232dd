#pragma once

#include <optional>
#include <span>
#include <vector>

#include "frf/noise/noise_model.hpp"
#include "frf/noise/variance_law.hpp"
#include "frf/set/frf_source.hpp"

namespace jointid::virtualpoint {

/// Variances and covariances of the FRFs of a file as measured: those of the file, its coherences, or a law of noise.
class MeasuredErrors {
 public:
  MeasuredErrors(frf::FrfSource& source, const std::optional<frf::NoiseModel>& law);

  /// Whether they are known at all.
  bool known() const { return origin_ != Origin::none; }
  bool by_law() const { return origin_ == Origin::law; }

  /// Variances of real and imaginary part, as FrfSource::read_variance(). With a floor the first call reads the FRFs of all
  /// lines.
  void read_variance(const frf::Block& block, std::span<Complex> out);

  /// As FrfSource::read_covariance(); of a file without them the variances on the diagonal.
  void read_covariance(const frf::Block& block, std::span<Complex> out);

 private:
  enum class Origin { none, variance, coherence, law };
  void find_mean_squares();

  frf::FrfSource& source_;
  std::optional<frf::NoiseModel> model_;
  Origin origin_ = Origin::none;
  std::vector<double> mean_squares_;  ///< [R,C] of the stored FRFs, where the law has a floor
};

}  // namespace jointid::virtualpoint
