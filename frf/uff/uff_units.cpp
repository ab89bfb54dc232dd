#include "frf/uff/uff_units.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <string>

#include "frf/uff/uff_text.hpp"

namespace jointid::frf::uff {
namespace {

/// What records 9 and 10 say by their unit labels.
struct LabelledUnits {
  std::optional<Quantity> quantity;
  std::optional<double> numerator;
  std::optional<double> denominator;
};

std::optional<Quantity> quantity_of_time_exponent(int exponent) {
  if (exponent > 0 || exponent < -2) return std::nullopt;
  return static_cast<Quantity>(-exponent);
}

LabelledUnits read_labels(const Header58& header) {
  LabelledUnits read;
  const int motion_length = header.response.is_rotation() ? 0 : 1;
  const int load_length = header.reference.is_rotation() ? 1 : 0;
  const auto denominator = parse_label(header.denominator.unit);
  if (denominator && denominator->same_dimension({1.0, load_length, 0, 1}))
    read.denominator = denominator->si;
  const auto numerator = parse_label(header.numerator.unit);
  if (!numerator) return read;
  const auto quantity = quantity_of_time_exponent(numerator->time);
  const bool motion = numerator->force == 0 && numerator->length == motion_length;
  const bool ratio = numerator->force == -1 && numerator->length == motion_length - load_length;
  if (!quantity || (!motion && !ratio)) return read;
  read.quantity = quantity;
  read.numerator = numerator->si;
  if (ratio) read.denominator = 1.0;
  return read;
}

std::optional<Quantity> quantity_of_types(const Header58& header, const Place& place) {
  const int above = header.numerator.data_type;
  const int below = header.denominator.data_type;
  const bool motion = above == type_displacement || above == type_velocity || above == type_acceleration;
  if ((!motion && above > 1) || (below != type_force && below > 1)) {
    place.fail("records 9 and 10",
               "an FRF of data type " + std::to_string(above) + " over " + std::to_string(below) +
                   " is not displacement (8), velocity (11) or acceleration (12) over excitation force (13)",
               "export receptances, mobilities or accelerances");
  }
  if (!motion || below != type_force) return std::nullopt;
  if (above == type_displacement) return Quantity::receptance;
  return above == type_velocity ? Quantity::mobility : Quantity::accelerance;
}

constexpr const char* give_quantity =
    "give the key quantity = \"receptance\", \"mobility\" or \"accelerance\" under [data.files.\"NAME\"] in "
    "the scene, or "
    "--quantity of the command";

Quantity resolve_quantity(std::optional<Quantity> types, std::optional<Quantity> label,
                          std::optional<Quantity> given, const Header58& header, const Place& place) {
  if (given) return *given;
  if (!types) {
    place.fail("records 9 and 10",
               "data types " + std::to_string(header.numerator.data_type) + " and " +
                   std::to_string(header.denominator.data_type) + " do not say which quantity the FRF is",
               give_quantity);
  }
  if (label && label != types) {
    place.fail("record 9",
               "data type " + std::to_string(header.numerator.data_type) + " makes it " + name(*types) +
                   " but its unit '" + header.numerator.unit + "' makes it " + name(*label),
               give_quantity);
  }
  return *types;
}

}  // namespace

std::optional<Unit> parse_label(std::string_view label) {
  constexpr std::array<std::pair<char, std::string_view>, 4> spellings = {{{'\xB5', "u"}, {'\xB2', "^2"}, {'\xB3', "^3"}, {'\xB7', "*"}}};
  std::string ascii;
  for (const char c : one_byte_per_column(trim(label))) {
    const auto found = std::ranges::find(spellings, c, &std::pair<char, std::string_view>::first);
    ascii += found != spellings.end() ? std::string(found->second) : std::string(1, c);
  }
  return parse_unit(ascii);
}

Ordinate interpret_ordinate(const Header58& header, const UnitFactors& factors, std::optional<Quantity> given,
                            const Place& place) {
  LabelledUnits labels = read_labels(header);
  Ordinate ordinate;
  const auto types = quantity_of_types(header, place);
  ordinate.quantity = resolve_quantity(types, labels.quantity, given, header, place);
  ordinate.stated = types ? types : labels.quantity;
  if (labels.quantity && labels.quantity != ordinate.quantity) labels = {};
  const double motion = header.response.is_rotation() ? 1.0 : 1.0 / factors.length;
  const double load = (header.reference.is_rotation() ? 1.0 / factors.length : 1.0) / factors.force;
  ordinate.to_si = labels.numerator.value_or(motion) / labels.denominator.value_or(load);
  return ordinate;
}

std::optional<bool> spectrum_of_forces(const Header58& header) {
  if (header.numerator.data_type > 1) return header.numerator.data_type == type_force;
  const auto unit = parse_label(header.numerator.unit);
  return unit ? std::optional(unit->force == 1) : std::nullopt;
}

Ordinate interpret_spectrum(const Header58& header, const UnitFactors& factors, std::optional<Quantity> given, const Place& place) {
  const int turns = header.response.is_rotation() ? 1 : 0;
  const auto unit = parse_label(header.numerator.unit);
  if (spectrum_of_forces(header).value_or(false)) {
    const bool fits = unit && unit->same_dimension({1.0, turns, 0, 1});
    return {.to_si = fits ? unit->si : (turns == 1 ? 1.0 / factors.length : 1.0) / factors.force};
  }
  // That of the same motion over 1 N.
  Header58 motion = header;
  motion.denominator = {.data_type = type_force, .unit = "N"};
  motion.reference.direction = static_cast<int>(Direction::x);
  return interpret_ordinate(motion, factors, given, place);
}

double abscissa_to_hz(const Header58& header, const Place& place) {
  if (header.abscissa.data_type > 1 && header.abscissa.data_type != type_frequency) {
    place.fail(
        "record 8",
        "abscissa of data type " + std::to_string(header.abscissa.data_type) + " is not a frequency (18)",
        "export FRFs over frequency");
  }
  if (header.abscissa.unit == "kHz") return 1000.0;
  if (header.abscissa.unit == "rad/s") return 1.0 / (2.0 * std::numbers::pi);
  return 1.0;
}

}  // namespace jointid::frf::uff
