#pragma once

#include <string>

/// [[joints]] in a scene's text, which count from 1.
namespace jointid::gui {

int joints_in(const std::string& text);

/// The text with one more, behind the others; [joint] becomes the first of them.
std::string with_joint(std::string text);

/// The text without one of them and its tables.
std::string without_joint(const std::string& text, int number);

}  // namespace jointid::gui
