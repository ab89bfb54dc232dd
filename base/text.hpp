#pragma once

#include <span>
#include <string>

namespace jointid {

/// A number by a printf format of one double.
std::string digits(double value, const char* format = "%.2g");

/// "3.2 %" of 0.032, "41 %" of 0.412.
std::string percent(double share);

/// "a, b or c".
std::string one_of(std::span<const std::string> words);

}  // namespace jointid
