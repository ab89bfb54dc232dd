#pragma once

#include <complex>
#include <cstdint>
#include <optional>
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

/// Parses "receptance", "mobility" or "accelerance" in any case, and words that mean one of them without doubt ("inertance",
/// "dynamic compliance", "velocity/force"). Throws InputError that asks where a word leaves it open ("compliance", "admittance"),
/// says what it is where it is force over motion ("impedance"), and else names the nearest valid word.
Quantity parse_quantity(std::string_view text);

/// The same of a file's own word, with what the user gives where that is none.
Quantity parse_quantity(std::string_view text, std::optional<Quantity> given);

/// "taken for mobility, not for the accelerance that the file says"
std::string taken_for(Quantity given, Quantity stated);

/// Factor c with receptance = c · FRF at `frequency_hz`: 1, 1/(iω), −1/ω². At 0 Hz a mobility or an
/// accelerance fixes no receptance; the factor is then NaN, which reads "not measured" everywhere.
std::complex<double> to_receptance(Quantity quantity, double frequency_hz);

/// Inverse factor: 1, iω, −ω².
std::complex<double> from_receptance(Quantity quantity, double frequency_hz);

}  // namespace jointid::frf
