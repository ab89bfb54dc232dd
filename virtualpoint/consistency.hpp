#pragma once

#include <span>
#include <string>
#include <vector>

#include "frf/set/frf_source.hpp"
#include "virtualpoint/direction_fit.hpp"
#include "virtualpoint/transformation.hpp"

namespace jointid::virtualpoint {

/// How well the modes of a virtual point explain the FRFs of its sensors, or of its impacts, on some lines of a file: 1 is exact.
/// With F = R T and the sum u = Y 1 over the impacts: specific of a sensor i, the mean over the lines of
/// |u_i + ũ_i|²/(2|u_i|² + 2|ũ_i|²), ũ = F u; overall, ‖ũ‖/‖u‖ of every line. Impacts likewise with y = 1ᵀY, ỹ = y Fᵀ. Source:
/// pyFBS, VPT.consistency, whose F of weighted impacts is the transpose of this one; without weights they are the same.
struct SideConsistency {
  std::vector<frf::Dof> dofs;
  std::vector<double> specific;  ///< [n]
  std::vector<double> overall;   ///< [lines]

  bool any() const { return !dofs.empty(); }
};

/// What the FRFs of a file say of a virtual point.
struct Consistency {
  std::string file, point;  ///< point: "VP1"
  std::vector<double> frequency_hz;
  SideConsistency sensors, impacts;
  std::vector<double> rigidity;  ///< [lines] ‖F_u Y F_fᵀ‖/‖Y‖ (Frobenius): the share of all FRFs that the modes explain
  std::vector<WrongDirection> wrong;
};

/// Of `lines` of a source of measured FRFs; sums go over all references (responses) where the point has no impacts (sensors)
/// there. Lines with an FRF that was not measured are left out. Reads a line at a time and keeps the FRFs of the channels. Throws
/// as transformation().
Consistency consistency(frf::FrfSource& source, const VirtualPoint& point, std::span<const std::size_t> lines);

}  // namespace jointid::virtualpoint
