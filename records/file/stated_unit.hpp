#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace jointid::records {

/// Seconds of one unit of time, e.g. 1e-3 of "ms" and "msec"; nothing for what is none.
std::optional<double> seconds_of(std::string_view label);

/// Whether a label is that of something else than a time: a force, a motion, a voltage.
bool states_no_time(std::string_view label);

/// Whether a label is that of a quantity that is no force or motion, or of a signal before calibration: volts, counts, EU, dB,
/// Pa, strain (frf::not_a_unit()).
bool is_other_quantity(std::string_view label);

/// What the user says of numbers: SI = factor · (unit in SI) · number.
struct GivenUnit {
  std::string unit;
  double factor = 1.0;
};

/// Whether a unit that is given (its factor to SI, and that of the numbers) can be the stated one: it is the same within 1e-3, or
/// with the factor within 1 %.
bool agree(double stated_si, double given_si, double factor);

/// Why the unit that a file states and the one that is given cannot both hold, or empty. They agree where they do (agree()),
/// where the stated one is not understood, and, as a factor calibrates, for
/// another quantity (is_other_quantity()) with a factor.
std::string contradiction(std::string_view stated, const GivenUnit& given);

/// Throws InputError (data) at `place` for a contradiction().
void require_agreement(std::string_view stated, const GivenUnit& given, const std::string& file, const std::string& place);

}  // namespace jointid::records
