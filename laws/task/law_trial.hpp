#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace jointid::laws {

/// What one trial found; all that the statistics of a study need.
struct LawTrial {
  /// A number with its 95 % interval; NaN where there is none.
  struct Value {
    double value = 0.0, low = 0.0, high = 0.0;
  };
  std::size_t trial = 0;
  std::string status;  ///< word of the Status, "no_response" where the drawn parts have none
  std::string laws;    ///< chosen, as laws_text()
  bool usable = false, contradicts = false;
  bool undecided = false;     ///< other laws are as good
  bool missed = false;        ///< the true ones neither chosen nor among those
  double chi_square = 0.0;    ///< over its freedom; NaN where nothing was fitted
  std::vector<Value> values;  ///< as LawStudy::values; none unless usable with the true laws
};

/// Which trials are made, and who is told.
struct LawStudyOptions {
  std::size_t trials = 1000;
  std::uint64_t seed = 1;
  std::size_t threads = 1;
  std::function<bool()> interrupted{};                                  ///< asked between trials, by any thread
  std::function<void(std::size_t done, std::size_t total)> progress{};  ///< by one thread at a time
  std::vector<LawTrial> known{};                ///< trials that were made before, which are not made again
  std::function<void(const LawTrial&)> made{};  ///< told of each new one, by one thread at a time
};

/// A trial as a line of text with its end, of so many values (NaN where the trial has none), from which trial_of() makes it again
/// to the last bit: trial, status, laws, usable, contradicts, undecided, missed, χ² and each value with its interval, with commas
/// between.
std::string line_of(const LawTrial& trial, std::size_t values);

/// Empty where the line, without its end, is none of a trial of so many values.
std::optional<LawTrial> trial_of(const std::string& line, std::size_t values);

}  // namespace jointid::laws
