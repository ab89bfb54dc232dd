#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace jointid::frf {

/// A LabVIEW measurement file (.lvm): channels over one axis.
struct LvmFile {
  struct Channel {
    std::string name, unit;  ///< Y_Unit_Label; empty where it is not there
    std::vector<double> values;
  };
  std::string file;
  std::string dimension;          ///< X_Dimension: "Time", "Frequency"; "Time" where it is not there
  std::string x_unit;             ///< X_Unit_Label, or empty
  std::vector<double> x;          ///< as it stands there, or X0 + k Delta_X
  std::vector<Channel> channels;  ///< those of the first segment
  std::size_t titles_line = 0;    ///< line of the row X_Value …, from 1
};

/// Whether a text begins as one does.
bool looks_like_lvm(std::string_view head);

/// Reads one: keys up to ***End_of_Header***, those of the segment likewise, a row of titles from X_Value on, numbers; tabs or
/// commas between, decimal point or comma, X_Columns No, One or Multi. The column Comment is passed over. Throws InputError
/// naming the line: no titles, what is no number, several segments, axes of channels that differ.
LvmFile read_lvm(const std::string& file, std::string_view text);

}  // namespace jointid::frf
