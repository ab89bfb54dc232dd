#include "frf/set/units.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "frf/set/unit_label.hpp"

namespace jointid::frf {
namespace {

/// Motion per force: a length or an angle, over a force or a moment, over seconds to the quantity's power. An angle leaves no
/// length above.
bool fits(const Unit& unit, Quantity quantity) {
  const bool motion = std::abs(unit.length) <= 1 && (unit.angle == 0 || (unit.angle == 1 && unit.length < 1));
  return unit.force == -1 && unit.time == -static_cast<int>(quantity) && motion;
}

[[noreturn]] void fail(std::string problem, std::string remedy) {
  throw InputError(
      {.kind = ErrorKind::data, .file = {}, .place = {}, .problem = std::move(problem), .remedy = std::move(remedy)});
}

/// A proposal comes first, an explanation last.
std::string with_hint(const std::string& hint, const std::string& remedy) {
  if (hint.empty()) return remedy;
  return hint.ends_with('?') ? hint + " Or " + remedy : remedy + "; " + hint;
}

}  // namespace

double si_factor(std::string_view unit_label, Quantity quantity) {
  constexpr std::size_t longest = 100;
  const std::string shown = shown_label(unit_label);
  const std::string remedy = "write " + frf::unit(quantity) + ", or another product of " + unit_names();
  const std::optional<Unit> parsed = unit_label.size() > longest ? std::nullopt : parse_unit(unit_label);
  if (!parsed) fail("unknown unit '" + shown + "'", with_hint(unit_label.size() > longest ? "" : unit_hint(unit_label), remedy));
  if (!fits(*parsed, quantity)) fail("unit '" + shown + "' is not a unit of " + name(quantity), remedy);
  return parsed->si;
}

std::optional<Quantity> quantity_of_unit(std::string_view unit_label) {
  const std::optional<Unit> parsed = parse_unit(unit_label);
  for (const Quantity quantity : {Quantity::receptance, Quantity::mobility, Quantity::accelerance}) {
    if (parsed && fits(*parsed, quantity)) return quantity;
  }
  return std::nullopt;
}

double si_factor(std::string_view unit_label, const FrfHeader& header) {
  const double factor = si_factor(unit_label, header.quantity);
  const auto rotates = [](const Dof& dof) { return dof.is_rotation(); };
  const bool rotations = std::ranges::any_of(header.response, rotates) || std::ranges::any_of(header.reference, rotates);
  const std::optional<Unit> parsed = parse_unit(unit_label);
  if (!rotations && parsed && (parsed->length != 1 || parsed->angle != 0)) {
    fail("unit '" + shown_label(unit_label) + "' is of a rotation or a moment, and all DOFs are translations",
         "write " + unit(header.quantity) + " or another length over a force, or name the rotations, e.g. 4:+RZ");
  }
  if (factor != 1.0 && rotations) {
    fail("unit '" + std::string(unit_label) + "' does not define the scale of rotations",
         "store sets with rotations in SI units, " + unit(header.quantity));
  }
  return factor;
}

std::string si_unit(Quantity quantity, const Dof& response, const Dof& reference) {
  constexpr std::array<const char*, 3> seconds = {"", "/s", "/s^2"};
  return std::string(response.is_rotation() ? "rad" : "m") + seconds[static_cast<std::size_t>(quantity)] +
         (reference.is_rotation() ? "/(N*m)" : "/N");
}

double si_factor(std::string_view unit_label, const FrfHeader& header, std::size_t r, std::size_t c) {
  const Dof &response = header.response[r], &reference = header.reference[c];
  const auto rotates = [](const Dof& dof) { return dof.is_rotation(); };
  if (std::ranges::none_of(header.response, rotates) && std::ranges::none_of(header.reference, rotates))
    return si_factor(unit_label, header);
  const double factor = si_factor(unit_label, header.quantity);
  const std::optional<Unit> parsed = parse_unit(unit_label);
  const int length = (response.is_rotation() ? 0 : 1) - (reference.is_rotation() ? 1 : 0);
  const bool angle = parsed && parsed->angle != 0 && !response.is_rotation();
  if (!parsed || parsed->length != length || angle) {
    fail("unit '" + shown_label(unit_label) + "' is not one of " + response.name() + "/" + reference.name() + ", a " +
             (response.is_rotation() ? "rotation" : "translation") + " over a " + (reference.is_rotation() ? "moment" : "force"),
         "write " + si_unit(header.quantity, response, reference) + ", or the DOFs that the unit is of");
  }
  return factor;
}

void require_frf_unit(std::string_view unit_label) {
  const std::string remedy = "write motion over force, e.g. m/(s^2*N), mm/s/N or g/lbf";
  if (!parse_unit(unit_label)) fail("unknown unit '" + shown_label(unit_label) + "'", with_hint(unit_hint(unit_label), remedy));
  if (!quantity_of_unit(unit_label))
    fail("unit '" + shown_label(unit_label) + "' is no motion over a force", remedy);
}

}  // namespace jointid::frf
