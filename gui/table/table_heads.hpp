#pragma once

#include <QString>
#include <string>

namespace jointid::gui {

/// The title of a column of a table that reports share, in the language of the window where it has the word.
QString head_text(const std::string& title);

}  // namespace jointid::gui
