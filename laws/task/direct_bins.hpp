#pragma once

#include <vector>

#include "laws/task/identify_laws.hpp"

namespace jointid::laws {

/// States of similar motion of a joint: medians.
struct DirectBin {
  double motion = 0.0;            ///< |Q₁|, m
  Complex equivalent, deviation;  ///< k_e + i d_e, of a single state
  std::size_t states = 0;
};

/// The direct step of one joint over its motion, at most `most` bins of equally many states; those without harmonic 1 are left
/// out.
std::vector<DirectBin> direct_bins(const std::vector<response::DirectStep>& steps, Eigen::Index joint, std::size_t most);

}  // namespace jointid::laws
