#pragma once

#include <cstddef>
#include <optional>

#include "correlation/correlated_modes.hpp"
#include "correlation/expansion.hpp"
#include "frf/set/frf_set.hpp"

namespace jointid::correlation {

/// FRFs at coordinates that were not measured.
struct ExpandedFrfs {
  frf::FrfSet set;                 ///< receptances, without variances: what a model has wrong is not known
  std::vector<frf::Dof> measured;  ///< b, as the measured file has them
  std::vector<frf::Dof> left_out;  ///< coordinates of the measured file that were not used
  /// At b, rms over lines and FRFs over their rms: of SEMM |Y_p − Y_o|, how good the parent is there; of SEREP what the modes do
  /// not carry.
  double parent_error = 0.0;
};

/// mixed() on every line that both sets have. b: coordinates that are responses and references of both. The parent's responses
/// are its references. Throws InputError (data) where there are none, or the parent has gaps.
ExpandedFrfs expanded(const frf::FrfSet& parent, const frf::FrfSet& measured, Semm way);

/// serep() with the first `modes` of the parent (0: all): responses of the measured set become those of all its coordinates,
/// references stay.
ExpandedFrfs expanded(const ModeFile& parent, const frf::FrfSet& measured, std::size_t modes);

}  // namespace jointid::correlation
