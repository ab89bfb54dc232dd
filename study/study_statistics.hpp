#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "ident/scene/scene.hpp"

namespace jointid::study {

inline constexpr std::array<double, 5> study_quantiles = {0.05, 0.25, 0.50, 0.75, 0.95};
using Quantiles = std::array<double, 5>;

/// An unknown over all trials that gave an estimate, in SI units.
struct UnknownStatistics {
  std::string name, unit;
  std::optional<double> truth;
  double mean = 0.0;
  double std_deviation = 0.0;       ///< with n−1
  std::optional<double> bias;       ///< mean − truth
  std::optional<double> rms_error;  ///< sqrt(mean (x − truth)²)
  Quantiles quantiles{};            ///< linear between order statistics, at 1 + (n−1)q
  std::optional<double> coverage;   ///< share of 95 % intervals that hold the truth
};

struct QualityStatistics {
  std::string matrix;  ///< "stiffness"
  Quantiles rjcf{}, arvf{}, rms_relative_error{};
  double rms_over_trials = 0.0;  ///< rms of the relative errors of all elements in all trials
};

struct StudyStatistics {
  std::size_t trials = 0;
  std::size_t usable = 0;  ///< trials with status ok or doubtful; only they count below
  std::size_t rank_deficient = 0, no_equations = 0, not_converged = 0;
  std::size_t doubtful = 0;  ///< of the usable ones
  std::size_t poor_fit = 0;
  std::vector<UnknownStatistics> unknowns;
  std::vector<QualityStatistics> quality;
};

/// What the result file of a study says, by passes over its columns: memory does not grow with the number of trials. Sums run in
/// the order of the trials, so equal files give equal statistics; quantiles are exact. Throws InputError when it is no such file.
StudyStatistics study_statistics(const ident::Path& file);

}  // namespace jointid::study
