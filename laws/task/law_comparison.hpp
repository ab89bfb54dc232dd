#pragma once

#include <string>
#include <vector>

#include "laws/task/law_study.hpp"

namespace jointid::laws {

/// How a way of identifying meets one number over the trials that it answers.
struct WayError {
  std::size_t answers = 0;
  double bias = 0.0, rms_error = 0.0;  ///< NaN without an answer
};

/// A stiffness or a friction limit.
struct ComparedValue {
  std::string joint, name, unit;
  double truth = 0.0, bound = 0.0;  ///< bound: its deviation there; NaN where the data do not see it
  std::vector<WayError> ways;       ///< as LawComparison::ways
};

/// Ways of identifying laws of friction joints on the same simulated tests.
struct LawComparison {
  std::vector<std::string> laws;  ///< the true ones, known to both ways
  bool assumed = true;            ///< told by the scene, else found from the measured levels
  std::size_t trials = 0, without_response = 0;
  std::vector<std::string> ways = {"likelihood", "two_steps"};
  std::vector<double> seconds;  ///< of a trial by the clock, median; as `ways`
  std::vector<ComparedValue> values;
  std::vector<std::string> notes;
};

/// The likelihood and the thesis's two steps (two_steps()) find the stiffness and the limit of every joint in the trials of
/// study_laws(). Of the options known and made are of studies. Throws as study_laws().
LawComparison compare_law_ways(const LawScene& scene, const LawStudyOptions& options);

}  // namespace jointid::laws
