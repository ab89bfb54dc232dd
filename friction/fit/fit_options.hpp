#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace jointid::friction {

/// By what a residual T_e − T_a is divided before it is squared. Equivalents are always divided by √(k_e² + d_e²) (7.20).
/// See docs/formulas.md §10f.
enum class Weighting : std::uint8_t {
  none,      ///< nothing (2.58a)
  largest,   ///< the largest |T_e| of the curve (2.58b)
  relative,  ///< |T_e|, at least 1 % of the largest
  travel,    ///< the largest |T_e|, and the square weighs by the way to the neighbouring samples: dwells count as nothing
};

enum class Minimiser : std::uint8_t {
  best,     ///< Ceres, or pattern search in a build without it
  ceres,    ///< Levenberg–Marquardt with analytic derivatives
  pattern,  ///< Hooke and Jeeves, as the thesis
};

struct FitOptions {
  Weighting weighting = Weighting::largest;
  Minimiser minimiser = Minimiser::best;
  std::optional<double> limit{};  ///< preset friction limit, which ties one parameter of the law to the others
  bool friction_coefficient = false;  ///< limit = μ·normal_load of every curve, with one unknown μ
  std::function<bool()> interrupted{};  ///< asked before residuals of a curve are worked out: Interrupted is thrown soon
  std::vector<std::string> shared{};  ///< parameters that have one value for all curves
};

std::string name(Weighting weighting);
Weighting parse_weighting(const std::string& word);  ///< throws InputError

}  // namespace jointid::friction
