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

}  // namespace jointid::frf
