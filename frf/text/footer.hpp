#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace jointid::frf {

/// Whether a line below rows of `columns` numbers is one of words: "End of data", "Averages;10", "-----", "[10 rows x 3
/// columns]". `cells` are its cells. No line is that begins like a number or says that a number is missing, nor one that has a
/// number in every column behind a word ("Max,1.0,2.0").
bool is_footer(const std::vector<std::string_view>& cells, std::size_t columns);

/// "Page 2 of 3", "- 2 -", "Seite 2/3": a line that may stand between rows.
bool is_page_mark(std::string_view text);

/// Whether it says that a measurement is not whole or not right: "Overload in channel 3", "aborted by user".
bool warns_of_data(std::string_view text);

/// Whether a table of numbers breaks off: its last line has no end, and its last number has fewer characters behind the decimal
/// sign than those above it, all of which have as many.
bool ends_in_a_cut_number(std::string_view text);
inline constexpr const char* cut_number = "the last line has no end, and its last number has fewer digits than those above it";
inline constexpr const char* whole_file = "the file is cut off: export or copy it again. If it is whole, end its last line";

}  // namespace jointid::frf
