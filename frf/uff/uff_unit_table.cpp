#include "frf/uff/uff_unit_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string>
#include <string_view>

#include "frf/uff/uff_text.hpp"

namespace jointid::frf::uff {
namespace {

/// The units codes of the format with their factors; 9 is defined by the user.
struct CodedUnits {
  std::int64_t code;
  const char* name;
  double length, force;
};
constexpr double foot = 0.3048, pound_force = 4.4482216152605, gravity = 9.80665, poundal = 0.138254954376;
constexpr std::array coded_units = std::to_array<CodedUnits>({{1, "m and N", 1.0, 1.0},
                                                              {2, "ft and lbf", 1.0 / foot, 1.0 / pound_force},
                                                              {3, "m and kgf", 1.0, 1.0 / gravity},
                                                              {4, "ft and poundal", 1.0 / foot, 1.0 / poundal},
                                                              {5, "mm and mN", 1e3, 1e3},
                                                              {6, "cm and cN", 1e2, 1e2},
                                                              {7, "in and lbf", 12.0 / foot, 1.0 / pound_force},
                                                              {8, "mm and kgf", 1e3, 1.0 / gravity},
                                                              {10, "mm and N", 1e3, 1.0}});

std::string contradiction_of(std::int64_t code, double length, double force) {
  constexpr double tolerance = 0.01;
  const auto found = std::ranges::find(coded_units, code, &CodedUnits::code);
  constexpr double of_largest_unit = 0.099;  // 10 m: a smaller factor is one from the unit to m
  if (found == coded_units.end() && length < of_largest_unit)
    return fmt::format("dataset 164 has the factor of length {:.5g}, a unit of {:.5g} m: it is to divide lengths in m by it",
                       length, 1.0 / length);
  if (found == coded_units.end()) return {};
  const auto off = [](double stated, double coded) { return std::abs(stated - coded) > tolerance * coded; };
  if (!off(length, found->length) && !off(force, found->force)) return {};
  return fmt::format("dataset 164 has units code {}, {}, whose factors are {:.5g} and {:.5g}, and the factors {:.5g} and {:.5g}",
                     code, found->name, found->length, found->force, length, force);
}

UnitFactors parse_factors(ByteFile& file, const Dataset& dataset) {
  std::string codes, line;
  std::string_view next;
  file.seek(dataset.payload_begin);
  for (int lines = 0; lines < 2 && file.position() < dataset.payload_end && file.next_line(next);) {
    if (trim(next).empty()) continue;
    (++lines == 1 ? codes : line) = next;
  }
  auto length = parse_real(column(line, 0, 25)), force = parse_real(column(line, 25, 25));
  if (const auto numbers = words(line); (!length || !force) && numbers.size() > 1)
    length = parse_real(numbers[0]), force = parse_real(numbers[1]);
  if (!length || !force || !(*length > 0.0) || !(*force > 0.0) || std::isinf(*length) || std::isinf(*force)) {
    dataset.place.fail("record 2", "'" + line + "' does not begin with two positive unit factors",
                       "correct the factors of length and force");
  }
  return {*length, *force, contradiction_of(parse_integer(column(codes, 0, 10)).value_or(0), *length, *force)};
}

}  // namespace

UnitTable::UnitTable(ByteFile& file, const std::vector<Dataset>& datasets) {
  for (const Dataset& dataset : datasets) {
    if (dataset.number == 164 && !dataset.binary) entries_.push_back({dataset.place.byte, parse_factors(file, dataset)});
  }
}

UnitFactors UnitTable::at(const Dataset& dataset) const {
  if (entries_.empty()) return {};
  const auto after =
      std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) { return entry.byte > dataset.place.byte; });
  return after == entries_.begin() ? after->factors : std::prev(after)->factors;
}

}  // namespace jointid::frf::uff
