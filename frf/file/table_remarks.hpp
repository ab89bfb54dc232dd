#pragma once

#include <functional>
#include <optional>
#include <string>

#include "frf/file/columns.hpp"
#include "frf/text/unit_names.hpp"

namespace jointid::frf {

/// A unit that a remark above a table states, and nothing reads.
struct UnreadUnit {
  std::string place, unit;
};

/// The first unit other than SI of a kind that is asked for in remarks: a word ("all in mm", "units: mm, kN"), none behind a
/// number
/// ("thickness 5 mm"), and what stands in brackets at the end or behind a colon ("ylabel: Acceleration [g]").
std::optional<UnreadUnit> unread_unit(const Columns& columns, const std::function<bool(const Unit&)>& is_asked_for);

/// Throws InputError where a remark, a title or an attribute states a factor that nothing applies: "scale = 0.1", "values x
/// 1000", "F x1000 [N]".
void require_no_factor(const Columns& columns);

/// A sensitivity, a gain or a calibration that a remark states, "# sensitivity: 20 mV/N", "# not calibrated", or a few numbers
/// beside the columns are, by their name: numbers of columns whose unit nothing states may be volts. None where the remark states
/// that it is applied. `unit` is the text of the remark.
std::optional<UnreadUnit> unapplied_sensitivity(const Columns& columns);

}  // namespace jointid::frf
