#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "frf/set/frf_set.hpp"
#include "virtualpoint/transformation.hpp"

namespace jointid::virtualpoint {

/// What a coordinate takes of the measured ones.
struct Share {
  std::size_t channel;  ///< index into the measured DOFs
  double factor;
};

/// The coordinates of one side (responses or references) of a source with virtual points, as sums of measured ones.
struct Mixture {
  std::vector<frf::Dof> dofs;
  std::vector<std::vector<Share>> shares;  ///< [coordinate]
};

/// The measured DOFs that no virtual point takes, then those of the points. Throws InputError where a DOF is there twice.
Mixture mixture(const frf::FrfHeader& header, Side side, const std::vector<VirtualPoint>& points);

/// 0, 1, …, count − 1.
std::vector<std::size_t> first_indices(std::size_t count);

/// Some coordinates of a mixture over the measured DOFs that they need.
struct PickedMixture {
  PickedMixture(const Mixture& whole, std::span<const std::size_t> wanted);

  std::vector<std::size_t> channels;       ///< measured, ascending
  std::vector<std::vector<Share>> shares;  ///< [wanted], `channel` an index into `channels`
};

}  // namespace jointid::virtualpoint
