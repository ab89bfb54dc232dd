#pragma once

#include "oscillation/pod/pod.hpp"

namespace jointid::oscillation {

/// Shares Σ_{i≤k}σ²/Σσ² of a record with standard errors.
struct Fractions {
  Eigen::VectorXd value, error;
};

/// Errors by a jackknife over `blocks` ≥ 2 stretches of equal length, each long beside the record's memory: they are too small
/// where it is not, and mean nothing for a periodic record. Throws InputError for fewer samples than blocks.
Fractions square_fractions(const Eigen::Ref<const Samples>& record, std::size_t blocks = 20, const PodOptions& options = {});

}  // namespace jointid::oscillation
