#pragma once

#include <optional>
#include <vector>

#include "records/order/order_fit.hpp"

namespace jointid::records {

/// The phase of a channel whose first order is most of it, by its upward zero crossings: 2πk at the k-th.
class PhaseTrack {
 public:
  /// Of samples from `settle_s` on, less their mean. A crossing counts once the signal was below and comes above a third of its
  /// last cycle's peak, so that noise makes none. Throws InputError (data) where there are less than 8.
  PhaseTrack(const Record& record, std::size_t channel, double settle_s);

  /// One stretch of whole periods over all of it, with the mean frequency (α = 0).
  OrderStretch whole() const;

  /// A stretch of so many periods about the first moment at which the frequency is that of a line; nothing where it never is, or
  /// so near to an end that the stretch does not fit.
  std::optional<OrderStretch> about(double hz, int periods) const;

  /// Mean frequency over so many periods at the start, at the end, and the highest and lowest of all.
  struct Course {
    double first_hz = 0.0, last_hz = 0.0, lowest_hz = 0.0, highest_hz = 0.0;
  };
  Course course(int periods) const;

 private:
  double mean_hz(std::size_t from, int periods) const;
  OrderStretch fitted(std::size_t from, std::size_t to, bool sweeps) const;

  std::vector<double> crossings_;
};

}  // namespace jointid::records
