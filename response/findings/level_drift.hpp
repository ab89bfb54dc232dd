#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <vector>

#include "response/identify/law_fit.hpp"

namespace jointid::response {

/// One level that speaks for other laws' parameters than all the others do.
struct LevelDrift {
  std::size_t level = 0;
  double chi_square = 0.0;    ///< by how much χ² would fall with parameters of its own
  Eigen::Index freedom = 0;   ///< how many of them the level and the others together tell
  Eigen::VectorXd change;     ///< of each unknown: by what part of its value the level's own parameter differs
  Eigen::VectorXd deviation;  ///< of each change; NaN where the level does not tell it

  bool is_told() const;  ///< χ² falls by more than 4 deviations of chance
};

/// The score test of each level: at the end of a fit, to first order, the least χ² with the unknowns θ + δ_p in the states of
/// level p and θ in all others, errors of receptances and forces as in the fit (all levels of a line share those of H). Tells a
/// preload that drifted between levels and a force that is off at one of them, where no response is left to test the data alone.
/// `level` of each state; the largest fall first. Empty where there is one level, or the fit has no minimum.
std::vector<LevelDrift> test_level_drift(const std::shared_ptr<const Receptance>& structure,
                                         const std::vector<MeasuredState>& states, const std::vector<std::size_t>& level,
                                         const LawUnknowns& unknowns, const LawFit& fit);

}  // namespace jointid::response
