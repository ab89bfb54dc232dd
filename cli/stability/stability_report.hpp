#pragma once

#include <string>
#include <vector>

#include "report/text/table.hpp"
#include "stability/sweeps.hpp"

namespace jointid::cli {

struct StabilityReport {
  std::vector<stability::Measured> rows;
  stability::Count count;  ///< of random scenes
  std::uint64_t seed = 0;
  bool interrupted = false;  ///< not all rows and scenes are there

  /// The rows of one sweep.
  std::vector<stability::Measured> of(const std::string& sweep) const;
};

/// Digits against what a sweep varies: one row per value, one column per method and solver; NaN where there is none.
struct DigitTable {
  std::vector<double> values;
  std::vector<std::string> ways;                ///< "qr", "method two", …
  std::vector<double> condition;                ///< per value, of the first way
  std::vector<std::vector<double>> digits;      ///< [way][value]
};
DigitTable digit_table(const std::vector<stability::Measured>& rows);

/// That table with its conditions; one row per method and solver with range of digits, time, memory and outcomes; verdicts of sweeps
/// and random scenes.
report::Table digits_table(const stability::Sweep& sweep, const std::vector<stability::Measured>& rows);
report::Table cost_table(const std::vector<stability::Measured>& rows);
report::Table verdict_table(const StabilityReport& report);

std::string stability_text(const StabilityReport& report);
std::string stability_json(const StabilityReport& report);
std::string stability_csv(const StabilityReport& report);

}  // namespace jointid::cli
