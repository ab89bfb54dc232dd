#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace jointid::ident {

/// Σ factors[i]·δ(names[i])/scale, Σ factors² = 1. The scale is the estimate; if that is nearly zero, the largest estimate of the
/// same matrix and unit. `deviation` is its standard deviation.
struct LinearCombination {
  std::vector<std::string> names;
  std::vector<double> factors;
  double deviation = 0.0;
};

/// Unknowns that the data do not separate: their least determined combination and, if there are several, the best determined
/// one.
struct WeakCombination {
  LinearCombination worst;
  std::optional<LinearCombination> best;
  std::optional<double> correlation;  ///< of the first two unknowns
};

/// Visibility of a joint in the data; medians.
struct JointVisibility {
  std::optional<double> effect;       ///< |H_sub − H_asm| over its standard deviation; 0.7 when the joint changes nothing
  std::optional<double> deformation;  ///< work of the least determined combination in the assembly's motion over the parts'
};

/// Share of systematic errors (gains, delays, masses) in the variance of an unknown.
struct CalibrationShare {
  std::string unknown;
  double all = 0.0;  ///< share that would vanish if all of them were exactly known
  /// The same for one alone, largest first, those of 5 % or more, at most three.
  std::vector<std::pair<std::string, double>> largest;
};

enum class FindingKind { weak_combination, soft_joint, stiff_joint, nonlinear, misfit, calibration, gain };

std::string name(FindingKind kind);

/// Notes and remedies for the user, in sentences.
struct Finding {
  FindingKind kind;
  std::string text;
};

/// Identifiability of the unknowns from the data, and remedies.
struct Identifiability {
  std::vector<WeakCombination> weakest;  ///< least determined first, at most three
  JointVisibility joint;
  /// Joint DOFs that the joint holds together: their relative motion in the assembly is less than a tenth of that in the free
  /// parts (median over FRFs and lines). Empty if they are all DOFs of the joint.
  std::vector<std::array<std::string, 2>> stiff_pairs;
  double largest_relative_error = 0.0;   ///< of the determined unknowns; NaN if errors are not stated
  std::vector<CalibrationShare> calibration{};  ///< per determined unknown, if systematic errors are estimated
  std::vector<Finding> findings{};
};

}  // namespace jointid::ident
