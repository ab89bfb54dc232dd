#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace jointid::frf {

/// What a number with this name does to the numbers beside it: "scale", "gainFactor", "sens_acc", "to_si", "mV_per_g" multiply
/// them, "offset" is added. Words are parted by signs and by capitals; "loss_factor" and "time_scale" are of something else.
enum class NumberUse { none, multiplies, is_added };
NumberUse use_of_number(std::string_view name);

/// Whether a number with this name is known to be no factor of FRFs: "fs", "nfft", "zeta", "sensor_mass", "temperature", "nodes".
bool is_harmless_number(std::string_view name);

/// Whether a number with this name, one of each channel, is likely a factor of them: "amp", "weights", "coeff".
bool may_be_channel_factor(std::string_view name);

/// The factor that a remark states: "multiply by 1e-3", "values x 1000", "(x1000)"; nothing of any other text.
std::optional<double> stated_factor(std::string_view text);

/// Whether a remark in words speaks of numbers that are not those of the unit beside them: a factor, gain or calibration with a
/// number
/// ("gain: 10 dB", "values are x 1e-3"), "not calibrated", "ADC counts", "inverse FRF". Dates, numbers of certificates and
/// sensitivities of sensors ("100 mV/g"), which analysers apply, are none.
bool doubts_numbers(std::string_view remark);

/// Whether a remark states a sensitivity or calibration with a number, as of a sensor, or volts: "# sensitivity 10 mV/N", "data in V".
bool states_sensitivity(std::string_view remark);

/// The power of ten that a title of a column states beside its unit: "Real x1000 [g/N]", "Re (x10e-3)", "Im ×10^3". "x1" and
/// "x12" may be names of points.
std::optional<double> factor_in_title(std::string_view title);

/// Whether an array with this name is computed from FRFs or is no motion over force: "Z", "dyn_stiff", "Hinv", "H_transposed",
/// "logH", "H_dB", "dH", "H_err".
bool is_of_something_else(std::string_view name);

/// Whether a text states motions of exp(-iωt), whose FRFs are conjugates: "exp(-jwt)", "e^{-i\omega t}", "conjugated".
bool states_conjugates(std::string_view text);

}  // namespace jointid::frf
