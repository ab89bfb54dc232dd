#pragma once

#include <string>
#include <string_view>

namespace jointid::frf {

/// A name and the unit that it ends in behind an underscore or a blank.
struct SuffixedName {
  std::string_view name;  ///< "acc" of "acc_m_s2", "test.u" of "test.u_mm"
  std::string unit;       ///< "m/s2", "mm"; empty where the name states none
};

/// By names as programs write them, without brackets: "F_N", "u_mm", "acc_m_s2", "vel_mm_per_s", "t_ms", "Axial Force kN". A unit
/// of one letter, "in", "ft", "min" and the like count only behind a word of their own quantity: "x_in" is in inches, "F_in" and
/// "peak_g" are names. Two words are a ratio, and N_m behind a torque a product.
SuffixedName suffixed_name(std::string_view name);

/// "N/mm" of the name of a matrix, "K_N_mm", and "tonne" of "M_tonne"; empty where it states no force over length and no mass.
std::string stiffness_or_mass_suffix(std::string_view name);

}  // namespace jointid::frf
