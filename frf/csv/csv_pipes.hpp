#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace jointid::frf {

/// The same text with tabs between the cells of a table that stands between pipes, line by line: `| 10 | 1.2 | -3.4 |` as
/// Markdown, org-mode, databases and pandas write it, `10|1.2|-3.4`, and the lines of boxes ("│", "║") that Julia and terminals
/// draw. Rules
/// (`|---:|:---:|`, `+----+----+`) become empty lines. Empty where no line is a row of two numbers or more between pipes.
std::optional<std::string> tabs_for_pipes(std::string_view text);

}  // namespace jointid::frf
