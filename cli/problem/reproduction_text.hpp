#pragma once

#include <string>

#include "cli/problem/reproduction_report.hpp"

namespace jointid::cli {

/// The tables there are.
std::string table_list();

/// Print and ours entry by entry, how many prints lie inside, and notes.
std::string reproduction_text(const ReproductionReport& report);

/// One object per entry; keys stay.
std::string reproduction_json(const ReproductionReport& report);

/// One line per entry.
std::string reproduction_csv(const ReproductionReport& report);

}  // namespace jointid::cli
