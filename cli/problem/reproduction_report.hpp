#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "problems/thesis/reproduction.hpp"

namespace jointid::cli {

/// A table of the thesis, and what the trials give for it.
struct ReproductionReport {
  const problems::ThesisTable& table;
  std::size_t trials = 0;
  std::uint64_t seed = 0;
  std::vector<problems::Reproduced> results;  ///< one per entry
};

}  // namespace jointid::cli
