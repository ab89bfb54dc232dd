#pragma once

#include <complex>
#include <cstdint>
#include <string>
#include <string_view>

namespace jointid::frf {

/// What an FRF relates: motion over force. Everything is converted to receptance on entry.
enum class Quantity : std::uint8_t {
  receptance,  ///< displacement / force, m/N (rad/(N·m) for rotations)
  mobility,    ///< velocity / force
  accelerance  ///< acceleration / force
};

std::string name(Quantity quantity);

/// Unit of a translational FRF: m/N, m/(s·N) or m/(s²·N).
std::string unit(Quantity quantity);

/// Parses "receptance", "mobility" or "accelerance"; throws InputError with the nearest valid word.
Quantity parse_quantity(std::string_view text);

/// Factor c with receptance = c · FRF at `frequency_hz`: 1, 1/(iω), −1/ω². At 0 Hz a mobility or an
/// accelerance fixes no receptance; the factor is then NaN, which reads "not measured" everywhere.
std::complex<double> to_receptance(Quantity quantity, double frequency_hz);

/// Inverse factor: 1, iω, −ω².
std::complex<double> from_receptance(Quantity quantity, double frequency_hz);

}  // namespace jointid::frf
