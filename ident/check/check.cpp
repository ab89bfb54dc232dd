#include "ident/check/check.hpp"

#include <algorithm>

#include "ident/check/inquiry.hpp"

namespace jointid::ident {
namespace {

constexpr std::size_t lines_of_short_form = 24;

CheckResult check_lines(Plan& plan, const Control& control, std::size_t most, bool with_axis) {
  return inquire(read_checked_files(plan, most, control.interrupted), plan.coordinates.joint, control, with_axis);
}

}  // namespace

CheckResult check_data(Plan& plan, const Control& control) {
  return check_lines(plan, control, static_cast<std::size_t>(-1), true);
}

CheckResult quick_check(Plan& plan, const Control& control) { return check_lines(plan, control, lines_of_short_form, false); }

}  // namespace jointid::ident
