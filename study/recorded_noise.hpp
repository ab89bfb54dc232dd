#pragma once

#include <Eigen/Core>

#include "base/random.hpp"
#include "frf/set/excerpt.hpp"
#include "frf/set/frf_source.hpp"
#include "minimise/linear/correlation.hpp"

namespace jointid::study {

/// The covariances of a block of a source, as FrfSet::covariance of a set that has no more than that; empty where there are none.
std::vector<Complex> covariance_of(frf::FrfSource& source, const frf::Block& block);

/// Normal errors with the variances that a set records and, where there are covariances, what they have in common. FRFs whose
/// variance is not known stay as they are. Copies are independent: one per thread.
class RecordedNoise {
 public:
  /// A set with variances.
  explicit RecordedNoise(const frf::Excerpt& clean);

  /// `set`: a copy of the clean set. Numbers come from (seed, trial, set) of the stream, counted where the entries stand in the whole
  /// set.
  void pollute(frf::FrfSet& set, const RandomStream& stream) const;

 private:
  std::vector<std::uint64_t> line_start_, entry_;  ///< of Excerpt
  std::vector<Complex> deviation_;                 ///< of real and imaginary part, [F,R,C]
  std::vector<minimise::Correlation> correlations_;  ///< over the responses, [F,C]; empty without covariances
  std::vector<Eigen::MatrixXcd> between_;            ///< factor of the correlation of references, [F]; empty without
  std::size_t responses_, references_;
};

}  // namespace jointid::study
