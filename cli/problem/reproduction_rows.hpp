#pragma once

#include <string>
#include <vector>

#include "cli/problem/reproduction_report.hpp"

/// The rows of a table of the thesis and what became of its entries, for text and page.
namespace jointid::cli {

/// Entries [first, last) that stand in one row of the table.
struct RowOf {
  std::size_t first = 0, last = 0;
};

std::vector<RowOf> rows_of(const std::vector<problems::TableEntry>& entries);

struct Count {
  std::size_t inside = 0, legible = 0, doubtful = 0;  ///< inside: of the legible
};

Count count(const ReproductionReport& report);

/// "71 of 100 entries of the print lie inside …", and how many are doubtful.
std::string verdict_text(const Count& counted);

/// A number with four significant digits; "–" when it is not finite.
std::string four_digits(double value);

}  // namespace jointid::cli
