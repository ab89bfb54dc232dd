#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "frf/set/dof.hpp"
#include "frf/uff/uff_bytes.hpp"

namespace jointid::frf::uff {

/// Function types of record 6 that this program tells apart.
inline constexpr int function_frf = 4;
inline constexpr int function_coherence = 6;
inline constexpr int function_spectrum = 12;
inline constexpr int function_multiple_coherence = 26;

/// Specific data types of records 8–11 that this program tells apart.
inline constexpr int type_displacement = 8;
inline constexpr int type_velocity = 11;
inline constexpr int type_acceleration = 12;
inline constexpr int type_force = 13, type_reaction_force = 9;
/// Excitation or reaction force.
constexpr bool is_force_type(int type) { return type == type_force || type == type_reaction_force; }
inline constexpr int type_time = 17;
inline constexpr int type_frequency = 18, type_rpm = 19;

/// Number of header lines of a dataset 58.
inline constexpr std::size_t header_lines = 11;

/// Records 8–11: what stands on an axis.
struct AxisRecord {
  int data_type = 0;
  std::string unit;  ///< as the file has it, UTF-8; empty: none stated
};

/// Half of record 6. Direction codes: 0 scalar, ±1…3 translations, ±4…6 rotations.
struct DofRecord {
  std::int64_t node = 0;
  int direction = 0;
  std::string entity{};  ///< name, UTF-8; empty: none

  bool is_dof() const { return direction != 0 && node >= 0; }

  bool is_rotation() const { return direction >= 4 || direction <= -4; }
  /// Needs a direction; a scalar has no DOF.
  Dof dof() const;
  std::string name() const;
};

/// Records 1–11 of a dataset 58 or 58b ("Function at Nodal DOF", revision of 30 June 1999).
struct Header58 {
  std::vector<std::string> id;  ///< five lines, UTF-8
  int function_type = 0;
  std::int64_t load_case = 0;
  DofRecord response;
  DofRecord reference;
  int ordinate_type = 0;  ///< 2 real single, 4 real double, 5 complex single, 6 complex double
  std::uint64_t points = 0;
  bool even = true;
  double abscissa_first = 0.0;
  double abscissa_step = 0.0;
  AxisRecord abscissa;
  AxisRecord numerator;
  AxisRecord denominator;
  std::string polar;  ///< a text of the header that says magnitudes and phases, "Magnitude/Phase"; empty: none

  std::string doubt{};  ///< what a text of the header states against its units or numbers, as a phrase; empty: none

  bool is_complex() const { return ordinate_type >= 5; }
  bool is_double() const { return ordinate_type == 4 || ordinate_type == 6; }
  /// Numbers in the file for each point: abscissa if uneven, real part, imaginary part if complex.
  std::uint64_t numbers_per_point() const { return (even ? 0u : 1u) + (is_complex() ? 2u : 1u); }
};

/// Parses the eleven header lines by their columns; throws InputError at `place`. Columns are characters; of bytes where a name
/// with letters of several bytes shifts the fields behind it, as it does where a program pads by bytes.
Header58 parse_header58(const std::array<std::string, header_lines>& lines, const Place& place);

/// Widths of the columns of a data line (record 12): 6E13.5, 4E20.12, 2(E13.5,E20.12) or E13.5,2E20.12.
std::span<const std::size_t> text_columns(const Header58& header);

/// The abscissa of an even record, first + i·step, as the file states it.
std::vector<double> even_abscissa(const Header58& header);

/// "time response", "frequency response function", …; the number in words when it is none of the standard's.
std::string function_name(int function_type);

}  // namespace jointid::frf::uff
