#pragma once

#include <string>
#include <vector>

#include "frf/mat/mat_variable.hpp"

namespace jointid::frf {

/// An array of complex numbers as a file has it: one variable, or two real ones NAME_real and NAME_imag (or _re and _im, or
/// fields real and imag of a struct NAME), or NAME_mag and NAME_phase (polar_name()).
struct ComplexArray {
  std::string name;
  const MatInfo* values = nullptr;
  const MatInfo* imaginary = nullptr;  ///< null: `values` is complex
  const MatInfo* phase = nullptr;      ///< not null: `values` are magnitudes
};

/// The arrays of a file that hold its FRFs: one, or the same field of every element of an array of structs.
///   - `variable` when given: a variable, a field, or a struct with one such array; run.H stands for the field H of all elements
///   of run;
///   - else `frf`;
///   - else the only complex array among the variables, or else in structs, with an axis as long as the frequencies (`axis`: the
///   variable of
///     these when given), where those are known.
/// Throws InputError where there is none, where several may be them, and where the one is real.
std::vector<ComplexArray> find_frfs(MatFile& file, const std::string& variable, const std::string& axis);

}  // namespace jointid::frf
