#pragma once

#include <span>
#include <string>

namespace jointid::oscillation {

/// Throws InputError (data) unless the series has at least `least` samples and all are finite.
void check_series(std::span<const double> x, std::size_t least);

/// The population standard deviation.
double deviation(std::span<const double> x);

/// Throws InputError (usage) with what is wrong with an option.
[[noreturn]] void wrong_option(const std::string& name, const std::string& problem);

}  // namespace jointid::oscillation
