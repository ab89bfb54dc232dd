#pragma once

#include <string>

#include "problems/reproduction.hpp"

namespace jointid::cli {

/// A table of the thesis, and what the trials give for it.
struct ReproductionReport {
  const problems::ThesisTable& table;
  std::size_t trials = 0;
  std::uint64_t seed = 0;
  std::vector<problems::Reproduced> results;  ///< one per entry
};

/// The tables there are.
std::string table_list();

/// Print and ours entry by entry, how many prints lie inside, and notes.
std::string reproduction_text(const ReproductionReport& report);

/// One object per entry; keys stay.
std::string reproduction_json(const ReproductionReport& report);

/// One line per entry.
std::string reproduction_csv(const ReproductionReport& report);

}  // namespace jointid::cli
