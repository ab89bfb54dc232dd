#pragma once

#include <functional>
#include <vector>

#include "frf/noise/wild_values.hpp"
#include "frf/set/frf_source.hpp"

namespace jointid::tasks {

/// What one pass over the FRFs tells beyond the header: what `jointid info` finds.
struct FrfCensus {
  std::size_t values = 0;     ///< lines × responses × references
  std::size_t missing = 0;    ///< values that are not measured (NaN)
  std::size_t zero_frfs = 0;  ///< response–reference pairs that are zero, or not measured, on every line
  bool covariance = false;    ///< the file holds covariances between responses
  bool references = false;    ///< and between references
  frf::FactorShape factor{};  ///< these are stored as a factor, or of rank 0
  bool complete = true;       ///< false when it was interrupted
  frf::WildValues wild{};     ///< values that are no number, infinite, or stand far out of their neighbours
  std::vector<frf::Dof> turned{};  ///< driving points that are not passive (frf::TurnedPoints)
};

/// Reads a source once, a few lines at a time, so that a file larger than the memory passes. Interrupted, what was
/// found so far, marked so.
FrfCensus take_census(frf::FrfSource& source, const std::function<bool()>& interrupted = {});

}  // namespace jointid::tasks
