#pragma once

#include <optional>
#include <span>
#include <string>

#include "frf/file/columns.hpp"

namespace jointid::records {

/// Whether times rise in even steps, to 1 % of one.
bool are_even(std::span<const double> times);

/// Samples per second of even times in s (1 % of a step at most off), as the number of six digits next to it where that is nearer
/// than 1e-6. Throws InputError (data) at `place` where times are not even, do not rise, or are less than two.
double rate_of(std::span<const double> times, const std::string& file, const std::string& place);

/// A rate that a file states at `place` and one that is given: the given one, which has more digits. Throws InputError (data)
/// where they differ by more than 1e-3.
double agreed_rate(double stated_hz, double given_hz, const std::string& file, const std::string& place);

/// Samples per second of a column of times in the unit that it states. A given rate decides for times that are not even, whose
/// unit is not understood, or that count samples (steps of 1, no unit stated); others it must agree with.
double stated_or_given_rate(const frf::NumberColumn& times, const std::string& file, std::optional<double> given_hz);

}  // namespace jointid::records
