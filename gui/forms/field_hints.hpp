#pragma once

#include <QString>
#include <string>

namespace jointid::gui {

/// What a key of the scene means, in a line, for its field; empty where nothing is to be said. Tables of all joint matrices, and
/// those of the truth and of the start, have one hint a key.
QString hint_of(const std::string& table, const std::string& key);

/// What a table is for: the title of its fields.
QString title_of(const std::string& table);

}  // namespace jointid::gui
