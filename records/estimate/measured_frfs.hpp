#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "frf/set/frf_set.hpp"
#include "records/estimate/frf_options.hpp"
#include "records/file/record.hpp"

namespace jointid::records {

/// What is behind the FRFs of one reference.
struct Averages {
  frf::Dof reference;
  std::size_t kept = 0, found = 0;
  double effective = 0.0;  ///< what kept ones are worth where they overlap
};

/// FRFs of a test, all that was averaged, and all that was not and why.
struct MeasuredFrfs {
  frf::FrfSet set;                 ///< with variances, and covariances where there are several responses and averages
  std::vector<Blow> blows;         ///< in the order of the records
  std::vector<Averages> averages;  ///< [C]
  std::vector<double> coherence;   ///< [F,R,C]; NaN of one average
};

/// Averages the blows (or segments) of each reference, the DOF of the force, over all records that have it. Segments may have
/// several forces at once, the same in all records, which are told apart by H1 (several_forces.hpp). The records must agree in
/// rate and in responses (DOFs, kinds, order). FRFs are stored as what the responses measured, or as receptance where they
/// measured different things. Throws InputError: records that do not agree, a reference of which no stretch is left, options out
/// of range. `interrupted`, if any, is asked between stretches (Interrupted).
MeasuredFrfs make_frfs(std::span<const Record> records, const FrfOptions& options, const std::function<bool()>& interrupted = {});

}  // namespace jointid::records
