#pragma once

#include <string>

#include "report/json_value.hpp"

namespace jointid::cli {

/// How the answers of two runs differ. Times, `provenance` and what `forecast` tells of times are no answers.
struct Difference {
  std::size_t values = 0;  ///< numbers, words and truths of the first
  std::size_t other = 0;   ///< those that are not the same, or not in both
  double largest = 0.0;    ///< |a − b| over the larger one, or over the largest number of its list or matrix; 1 where one is no number
  std::string at;          ///< "unknowns[3].value", the key of the largest
  std::string before, after;  ///< what is there

  bool same() const { return other == 0; }
};

Difference difference_of(const report::Json& before, const report::Json& after);

}  // namespace jointid::cli
