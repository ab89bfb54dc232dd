#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace jointid::ident {

/// Σ factors[i]·δ(names[i])/scale, where scale is the estimate, or the largest estimate of the same matrix and unit where the
/// estimate is nearly zero; Σ factors² = 1. `deviation` is its standard deviation.
struct LinearCombination {
  std::vector<std::string> names;
  std::vector<double> factors;
  double deviation = 0.0;
};

/// Unknowns that the data know badly together: the combination of them known worst and, when there are several, the one known
/// best.
struct WeakCombination {
  LinearCombination worst;
  std::optional<LinearCombination> best;
  std::optional<double> correlation;  ///< of the first two unknowns
};

/// How far a joint can be seen in the data; medians.
struct JointVisibility {
  std::optional<double> effect;       ///< |H_sub − H_asm| over its standard deviation; 0.7 when the joint changes nothing
  std::optional<double> deformation;  ///< work of the combination fixed worst on the assembly's motion over that on the free parts'
};

/// What systematic errors (gains, delays, masses) have of the variance of an unknown.
struct CalibrationShare {
  std::string unknown;
  double all = 0.0;  ///< what of its variance would go if all of them were known exactly
  /// The same of one alone, largest first, those of 5 % or more, at most three.
  std::vector<std::pair<std::string, double>> largest;
};

enum class FindingKind { weak_combination, soft_joint, stiff_joint, nonlinear, misfit, calibration, gain };

std::string name(FindingKind kind);

/// What the user should know or do, in sentences.
struct Finding {
  FindingKind kind;
  std::string text;
};

/// What the data say about the unknowns, and what would help.
struct Identifiability {
  std::vector<WeakCombination> weakest;  ///< worst first, at most three
  JointVisibility joint;
  /// Joint DOFs that the joint holds together: the assembly moves them against each other less than a tenth as much as the free
  /// parts (median over FRFs and lines). None when they are all that the joint has.
  std::vector<std::array<std::string, 2>> stiff_pairs;
  double largest_relative_error = 0.0;   ///< of the determined unknowns; NaN where errors are withheld
  std::vector<CalibrationShare> calibration{};  ///< per determined unknown, where systematic errors are estimated
  std::vector<Finding> findings{};
};

}  // namespace jointid::ident
