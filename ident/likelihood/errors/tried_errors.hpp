#pragma once

#include <optional>

#include "ident/likelihood/errors/block_jackknife.hpp"
#include "ident/likelihood/errors/common_gain.hpp"
#include "ident/likelihood/errors/shared_errors.hpp"
#include "ident/result/solution.hpp"

namespace jointid::ident {

/// What the data say at an estimate of errors that variances do not tell: gains of sensors (docs/gains.md), a gain of all FRFs of a
/// file, and what the responses to a reference have in common on a line.
struct TriedErrors {
  ErrorTrials trials;
  Scores scores;  ///< of the unknowns of the fit, then ErrorTrials::shared_by_lines()
  double inflation = 1.0;  ///< of errors, √(χ² over degrees of freedom) of the lines that count, at least 1
  std::vector<FileGain> files;  ///< empty where gains or masses are unknowns
  bool is_calibration_stated = false;  ///< [[data.gains]]
  std::vector<FileGain> stretches{};   ///< of the files' frequencies, in place of a gain
  SharedErrors shared;
  std::optional<BlockScores> blocks{};  ///< of the unknowns of the fit and, after them, of the stretches

  /// The stretch of the largest score, of the assembly where that of a part is not a standard deviation more; nullptr: none was tried.
  const FileGain* stretch() const;
  /// Without a block: from the estimate, or from where a stretch moves it.
  std::optional<Jackknife> jackknife(std::size_t known, const FileGain* taken) const;
};

/// In a pass over the lines. Sensors are tried with Detail::full and up to 256 of them; files where no systematic errors are
/// unknowns; shared errors where variances come from averages, FRFs are taken for independent, and there are
/// up to 256 references and phases. Of many lines sensors are tried in a second pass, and only where SensorScreen does not exclude
/// them: without a gain to tell there is none in `trials` then. `chi_square`: over degrees of freedom, of the lines that count. Empty
/// for parts that were coupled before. `nearby`: its gradients are worked out, too, where it has offsets.
std::optional<TriedErrors> try_errors(const Plan& plan, const LinearisedLikelihood& estimator, const LikelihoodFit& fit,
                                      double chi_square, const Control& control, LinearisedLikelihood::NearbyGradients& nearby);

}  // namespace jointid::ident
