#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "frf/set/frf_set.hpp"
#include "records/estimate/frf_options.hpp"
#include "records/file/record.hpp"

namespace jointid::records {

/// Averages of the FRFs of one reference.
struct Averages {
  frf::Dof reference;
  std::size_t kept = 0, found = 0;
  double effective = 0.0;  ///< effective number of the kept ones with overlap
};

/// FRFs of a test, with all segments: averaged, or rejected with the reason.
struct MeasuredFrfs {
  frf::FrfSet set;                 ///< with variances, and covariances if there are several responses and averages
  std::vector<Blow> blows;         ///< in the order of the records
  std::vector<Averages> averages;  ///< [C]
  std::vector<double> coherence;   ///< [F,R,C]; NaN of one average
};

/// Averages the impacts (or segments) of each reference, the DOF of the force, over all records that have it. Segments may have
/// several forces at once, the same in all records; H1 separates them (several_forces.hpp). The records must agree in rate and in
/// responses (DOFs, kinds, order). FRFs are stored in the quantity of the responses, or as receptance if the quantities differ.
/// Throws InputError for records that do not agree, a reference without a segment, options out of range. `interrupted`, if any,
/// is called between segments (Interrupted).
MeasuredFrfs make_frfs(std::span<const Record> records, const FrfOptions& options, const std::function<bool()>& interrupted = {});

}  // namespace jointid::records
