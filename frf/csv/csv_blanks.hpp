#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace jointid::frf {

/// The same text with tabs between the cells of a table whose numbers stand between blanks, line by line, as numpy.savetxt(),
/// MATLAB's `save -ascii` with titles and Fortran programs write it; empty where it holds no such table. Its rows are lines of
/// two numbers or more, all of one length, down to the last line of the text or up to 20 lines of words (is_footer()). The titles
/// above them are cut to as many cells: at separators of their own, at two blanks or more, at single blanks, with units in
/// brackets kept with their titles, and with the parts of FRFs kept with their labels ("4:+Y/1:+Y re").
std::optional<std::string> tabs_for_blanks(std::string_view text);

}  // namespace jointid::frf
