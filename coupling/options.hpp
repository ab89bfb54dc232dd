#pragma once

#include <optional>
#include <string>
#include <vector>

#include "coupling/methods.hpp"
#include "frf/noise/noise.hpp"

namespace jointid::coupling {

/// What is done about matrices that are nearly singular, docs/formulas.md §8.
enum class Threshold {
  none,
  fixed,   ///< grc, pcc: singular values σ ≤ epsilon·σ₁ are dropped (5.67)
  noise,   ///< grc, pcc: those not told apart from zero by the variances of the FRFs, truncate_noise()
  picard,  ///< grc, pcc: those from which the forces grow, truncate_picard()
  alpha    ///< mtc: conditions with alpha ≤ `alpha` are left out line by line (5.72)
};

std::string name(Threshold threshold);

struct Options {
  Method method = Method::grc;
  Threshold threshold = Threshold::none;
  double epsilon = 0.01;              ///< of `fixed`, 0 < epsilon < 1
  double alpha = 0.3;                 ///< of `alpha`, 0 < alpha < 2
  std::vector<bool> left_out{};         ///< conditions that are not met on any line; empty: none
  bool uncertainty = false;           ///< variances of the result to first order
  std::optional<frf::NoiseModel> noise{};  ///< the law of variances where files have none; without its floor
  std::size_t threads = 0;            ///< 0: all cores. The result does not depend on it.
};

/// Throws InputError (usage) with `where` as file for values outside their range and a threshold that the method does not have.
void validate(const Options& options, const std::string& where);

/// Whether variances of the parts' FRFs are read.
inline bool needs_variance(const Options& options) { return options.uncertainty || options.threshold == Threshold::noise; }

}  // namespace jointid::coupling
