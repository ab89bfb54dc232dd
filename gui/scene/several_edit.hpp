#pragma once

#include <string>

/// Tables of which a scene's text may have several, [[joints]] and [[data.gains]], which count from 1.
namespace jointid::gui {

int several_in(const std::string& text, const std::string& table);

/// "data.gains#2" of the second.
std::string one_of_several(const std::string& table, int number);

/// The text with one more, behind the others, or behind the table above: `lines` are those below its header.
std::string with_one_more(std::string text, const std::string& table, const std::string& lines);

/// The text without one of them and the tables below it.
std::string without_one(const std::string& text, const std::string& table, int number);

}  // namespace jointid::gui
