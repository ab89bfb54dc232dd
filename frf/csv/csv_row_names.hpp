#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace jointid::frf {

/// The same text with tabs between the cells and without names of rows, as write.table() of R writes them: a first line of
/// titles, all rows with one cell more, of which the first is a text in quotes or counts the rows from 1. Between blanks titles
/// in quotes are cut so, too, where rows have no names. Empty of any other text.
std::optional<std::string> without_row_names(std::string_view text);

}  // namespace jointid::frf
