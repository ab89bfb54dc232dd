#pragma once

#include <vector>

#include "ident/likelihood/errors/error_trials.hpp"
#include "ident/likelihood/errors/line_scores.hpp"

namespace jointid::ident {

/// What calibration is taken to be known to where a scene says nothing: the standard deviation of a gain that all FRFs of the assembly
/// have against those of the parts.
constexpr double usual_calibration = 0.01;

/// A gain of all FRFs of a file at an estimate that takes it for 1: true FRF = (1 + gain) · FRF of the file.
struct FileGain {
  FileTrial file;
  double gain = 0.0;       ///< of the score test, without a prior
  double error = 0.0;      ///< standard deviation of it
  double score = 0.0;      ///< gain/error, errors as large as χ² says
  Eigen::VectorXd answer;  ///< of the unknowns of the fit, to a gain of 1: dθ/dgain

  bool is_determined() const { return error > 0.0; }
  /// Of the gain by the data and a prior of 0 ± usual_calibration.
  double posterior_variance() const;
  double posterior_mean() const;
};

/// Of all files tried and, after these, of their stretches, from the scores of the unknowns of a fit, of sensors, and of these.
std::vector<FileGain> file_gains(const ErrorTrials& trials, const Scores& scores, std::size_t known, double inflation);

/// The gain that the data call for: of the largest score, at 4.5 standard deviations or more; nullptr: none.
const FileGain* telling_gain(const std::vector<FileGain>& gains);

/// While it lives the observations of a plan have the gain as an unknown, 1 ± usual_calibration.
class AssumedGain {
 public:
  AssumedGain(const Plan& plan, const FileTrial& file);
  ~AssumedGain();
  AssumedGain(const AssumedGain&) = delete;
  AssumedGain& operator=(const AssumedGain&) = delete;

 private:
  const Plan& plan_;
};

}  // namespace jointid::ident
