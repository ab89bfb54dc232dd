#include "records/file/stated_unit.hpp"

#include <cmath>

#include "base/error.hpp"
#include "frf/set/unit_label.hpp"

namespace jointid::records {
namespace {

bool near(double a, double b, double within) { return std::abs(a - b) <= within * std::abs(b); }

bool is_time(const frf::Unit& unit) { return unit.same_dimension({1.0, 0, 1, 0}); }

}  // namespace

std::optional<double> seconds_of(std::string_view label) {
  const auto unit = frf::parse_unit(label);
  return unit && is_time(*unit) ? std::optional(unit->si) : std::nullopt;
}

bool is_other_quantity(std::string_view label) {
  return !frf::parse_unit(label) && !frf::not_a_unit(frf::shown_label(label)).empty();
}

bool states_no_time(std::string_view label) {
  const auto unit = frf::parse_unit(label);
  return unit ? !is_time(*unit) : is_other_quantity(label);
}

bool agree(double stated_si, double given_si, double factor) {
  constexpr double same_unit = 1e-3, same_scale = 1e-2;
  return near(given_si, stated_si, same_unit) || near(factor * given_si, stated_si, same_scale);
}

std::string contradiction(std::string_view stated, const GivenUnit& given) {
  if (frf::states_no_unit(stated)) return {};
  const std::string says = "the file states " + frf::shown_label(stated) + ", and " + given.unit + " is given";
  if (is_other_quantity(stated)) return given.factor == 1.0 ? says : std::string();
  const auto file = frf::parse_unit(stated), option = frf::parse_unit(given.unit);
  if (!file || !option) return {};
  if (!file->same_dimension(*option)) return says;
  return agree(file->si, option->si, given.factor) ? std::string() : says;
}

void require_agreement(std::string_view stated, const GivenUnit& given, const std::string& file, const std::string& place) {
  const std::string problem = contradiction(stated, given);
  if (problem.empty()) return;
  throw InputError({ErrorKind::data, file, place, problem,
                    is_other_quantity(stated)
                        ? "give the factor, e.g. 22.4 " + given.unit + " for 22.4 " + given.unit + "/" + frf::shown_label(stated)
                        : "give the unit that the file states, or correct the file"});
}

}  // namespace jointid::records
