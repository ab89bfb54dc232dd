#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace jointid::oscillation {

/// A record over reversals of a rubbing contact: samples of equal number.
struct ReversalRecord {
  std::span<const double> displacement;  ///< of the slider against the nub, or of the slider alone, m
  std::span<const double> force;         ///< friction on the body, N, of the sign of the displacement that raises it
};

struct ReversalOptions {
  double share = 0.8;                    ///< straight parts have |F| ≤ share·μN; 0 < share < 1
  std::optional<double> slip_force{};    ///< μN, N; empty: the median of |F| where it is above half of the largest
  std::optional<double> body_stiffness{};  ///< K of the body at the nub, N/m, where the displacement is the slider's alone
};

/// Straight parts of one direction.
struct ReversalSlopes {
  std::size_t parts = 0;
  double slope = 0.0, error = 0.0;  ///< mean and its standard error by the scatter of the parts, N/m; error NaN of one part
};

/// The contact's stiffness by the slope of the force over the displacement after each reversal, between the limits of slip (Kappagantu
/// 4.8; he prints the force on the slider, with the other sign). The mean of both directions, which a tilt
/// parts. A delay of the force does not cancel: a sine speeds up after its reversals, so that both slopes become too flat.
struct ReversalStiffness {
  ReversalSlopes forward, backward;
  double slope = 0.0, slope_error = 0.0;  ///< mean of both, N/m
  double stiffness = 0.0;                 ///< K_C: the slope, or with the body's K in series sK/(K − s), N/m
  double slip_force = 0.0;                ///< μN, N
  double stuck_travel = 0.0;              ///< 2μN/K_C, m: how far a contact that has just turned sticks
  std::size_t skipped = 0;                ///< parts with fewer than 3 samples or without a travel
  std::string remark;                     ///< limits of the record; empty if there are none
};

/// Throws InputError (data) for lengths that differ, no straight part, or a slope not below the body's stiffness.
ReversalStiffness reversal_stiffness(const ReversalRecord& record, const ReversalOptions& options = {});

}  // namespace jointid::oscillation
