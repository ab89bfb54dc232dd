#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace jointid::frf {

/// A comment or a free line beside a table, as it stands there.
struct CsvRemark {
  std::size_t line = 0;
  std::string text;
};

/// Throws InputError where a remark states a unit other than SI that nothing reads, of FRFs whose unit nothing else states: the
/// unit of an FRF inside a sentence ("all values in g/N"), a unit of a force, a velocity or an acceleration alone between
/// separators or behind "in" ("Channel 2, Acceleration, g"), or a system of units ("mm, N, s").
void require_no_unit_in_remarks(const std::vector<CsvRemark>& remarks, const std::string& file);

/// What a remark states of a number that others multiply FRFs by, "gain = 2.5" and "sensitivity 10 mV/N", and that is not
/// applied, or of what the numbers are, "not calibrated": a phrase; else empty.
std::string factor_not_applied(const CsvRemark& remark);

/// A sensitivity that a remark states, of FRFs whose unit nothing states: a phrase; else empty.
std::string sensitivity_stated(const CsvRemark& remark);

/// What a remark states that differs from the unit of the FRFs, "acceleration in g" beside m/s^2/N, "frequencies in rad/s" beside
/// Hz, and "Response: V": a phrase; else empty.
std::string other_unit_stated(const CsvRemark& remark, const std::string& unit, double hz_per_unit);

}  // namespace jointid::frf
