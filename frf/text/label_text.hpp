#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// Labels of other programs' files as text: code pages, padding, signs that only some keyboards have.
namespace jointid::frf {

/// Length of the UTF-8 sequence that `text` begins with, 0 if it is none (overlong forms are left to be Latin-1).
std::size_t utf8_length(std::string_view text);

/// Without blanks, control bytes and quotes around it; what follows a NUL is padding.
std::string_view without_padding(std::string_view label);

/// "ms" of "[ms]" and "(ms)", blanks around it left out; "(m/s)/(N)" stays as it is.
std::string_view without_brackets(std::string_view label);

/// What may be the unit of a text: all of it, what stands in the last brackets at its end, and behind its last colon or equal
/// sign; "g/N" of "Accelerance [g/N]" and "y = g/N".
std::vector<std::string_view> labels_in(std::string_view text);

/// Words of a sentence that hold a stroke, "g/N" of "FRF in g/N (test 3)", without the signs around them, and what stands behind
/// the last "in", "g per N".
std::vector<std::string_view> ratios_in(std::string_view text);

/// Appends a character; half of a surrogate pair, and what is no character, as "?".
void append_utf8(std::string& out, std::uint32_t code);

/// The label in UTF-8: what is no valid UTF-8 is taken for Latin-1.
std::string utf8_label(std::string_view label);

/// In ASCII, for a parser: superscripts as ^2, dots and crosses as *, dashes as -, the micro sign as u, brackets as ( ), blanks
/// of all widths as one blank, ** as ^. Signs without a meaning in units stay as they are. Words written in two, "pound-force"
/// and "pk-pk", are made one.
std::string plain_label(std::string_view label);

}  // namespace jointid::frf
