#pragma once

#include <string>
#include <vector>

#include "laws/data/level_states.hpp"
#include "response/findings/level_drift.hpp"
#include "response/identify/direct_step.hpp"

namespace jointid::laws {

/// Even harmonics n ≥ 2 of a joint's force as the direct step finds them. A law of Masing's kind is the same in both directions
/// and has none; a residual preload with a gap, one-sided contact or slack has.
struct OneSidedJoint {
  std::size_t joint = 0;
  double chi_square = 0.0;     ///< Σ|F_n|²/σ²
  Eigen::Index freedom = 0;    ///< 2 of each state and even harmonic; 0: none was measured
  double largest_share = 0.0;  ///< of |F₁|, the largest

  bool is_told() const;  ///< χ² is above that of chance by more than 4 deviations
};
std::vector<OneSidedJoint> test_even_harmonics(const std::vector<response::DirectStep>& steps, Eigen::Index joints);

/// "left: its force has even harmonics, up to 12 % of F₁ (χ² …): …"
std::string one_sided_text(const OneSidedJoint& of, const std::string& joint);

/// "level 12 N speaks for another joint (χ² would fall by 310, 9.5 is chance): left k +12 % ± 1 %, …".
std::string drift_text(const response::LevelDrift& drift, const LawScene& scene, const response::LawUnknowns& unknowns);

}  // namespace jointid::laws
