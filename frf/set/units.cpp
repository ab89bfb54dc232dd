#include "frf/set/units.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "frf/set/unit_label.hpp"

namespace jointid::frf {
namespace {

/// Motion per force: a length or an angle, over a force or a moment, over seconds to the quantity's power.
bool fits(const Unit& unit, Quantity quantity) {
  return unit.force == -1 && unit.time == -static_cast<int>(quantity) && std::abs(unit.length) <= 1;
}

[[noreturn]] void fail(std::string problem, std::string remedy) {
  throw InputError({.kind = ErrorKind::data,
                    .file = {},
                    .place = {},
                    .problem = std::move(problem),
                    .remedy = std::move(remedy)});
}

}  // namespace

double si_factor(std::string_view unit_label, Quantity quantity) {
  constexpr std::size_t longest = 64;
  const std::string shown(unit_label.substr(0, longest));
  const std::string remedy =
      "write " + frf::unit(quantity) + ", or another product of " + unit_names();
  const std::optional<Unit> parsed = unit_label.size() > longest ? std::nullopt : parse_unit(unit_label);
  if (!parsed) fail("unknown unit '" + shown + "'", remedy);
  if (!fits(*parsed, quantity)) fail("unit '" + shown + "' is not a unit of " + name(quantity), remedy);
  return parsed->si;
}

double si_factor(std::string_view unit_label, const FrfHeader& header) {
  const double factor = si_factor(unit_label, header.quantity);
  const auto rotates = [](const Dof& dof) { return dof.is_rotation(); };
  if (factor != 1.0 && (std::any_of(header.response.begin(), header.response.end(), rotates) ||
                        std::any_of(header.reference.begin(), header.reference.end(), rotates))) {
    fail("unit '" + std::string(unit_label) + "' does not tell how rotations are scaled",
         "store sets with rotations in SI units, " + unit(header.quantity));
  }
  return factor;
}

}  // namespace jointid::frf
