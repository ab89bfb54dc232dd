#include "frf/uff/uff_units.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "frf/set/units.hpp"
#include "frf/text/label_text.hpp"
#include "frf/text/unit_names.hpp"
#include "frf/uff/uff_text.hpp"

namespace jointid::frf::uff {
namespace {

constexpr std::array data_type_names = std::to_array<std::pair<int, const char*>>({{0, "unknown"},
                                                                                   {1, "general"},
                                                                                   {2, "stress"},
                                                                                   {3, "strain"},
                                                                                   {5, "temperature"},
                                                                                   {6, "heat flux"},
                                                                                   {8, "displacement"},
                                                                                   {9, "reaction force"},
                                                                                   {11, "velocity"},
                                                                                   {12, "acceleration"},
                                                                                   {13, "excitation force"},
                                                                                   {15, "pressure"},
                                                                                   {16, "mass"},
                                                                                   {17, "time"},
                                                                                   {18, "frequency"},
                                                                                   {19, "rpm"},
                                                                                   {20, "order"}});

std::string data_type_name(int type) {
  const auto found = std::ranges::find(data_type_names, type, &std::pair<int, const char*>::first);
  return found != data_type_names.end() ? found->second : "type " + std::to_string(type);
}

bool is_motion(int type) { return type == type_displacement || type == type_velocity || type == type_acceleration; }

/// What records 9 and 10 say by their unit labels.
struct LabelledUnits {
  std::optional<Quantity> quantity;
  std::optional<double> numerator;
  std::optional<double> denominator;
  bool ratio = false;  ///< the label of record 9 is that of the whole FRF
};

constexpr const char* give_quantity =
    "give the key quantity = \"receptance\", \"mobility\" or \"accelerance\" under [data.files.\"NAME\"] in "
    "the scene, or "
    "--quantity of the command";

constexpr const char* give_unit =
    "export calibrated channels, or give the unit of its numbers: unit = \"m/(s^2*N)\" under [data.files.\"NAME\"] in the scene, or "
    "--unit of "
    "the command";

std::optional<Quantity> quantity_of_time_exponent(int exponent) {
  if (exponent > 0 || exponent < -2) return std::nullopt;
  return static_cast<Quantity>(-exponent);
}

[[noreturn]] void refuse(const char* record, const std::string& problem, const std::string& hint, const Place& place) {
  place.fail(record, problem + (hint.empty() || hint.ends_with('?') ? "" : ": " + hint),
             (hint.ends_with('?') ? hint + " Or " : "") + give_unit);
}

/// Empty where the label states none.
std::optional<Unit> stated_unit(const std::string& label, const char* record, const Place& place) {
  const auto unit = parse_unit(label);
  if (!unit && !states_no_unit(label)) refuse(record, "unknown unit '" + shown_label(label) + "'", unit_hint(label), place);
  return unit;
}

/// Rms over peak, and capitals alone above a unit that depends on them.
void require_together(const AxisRecord& above, const AxisRecord& below, const Place& place) {
  const std::string ratio = "(" + plain_label(above.unit) + ")/(" + plain_label(below.unit) + ")";
  if (parse_unit(above.unit) && parse_unit(below.unit) && !parse_unit(ratio)) {
    refuse("records 9 and 10", "units '" + shown_label(above.unit) + "' and '" + shown_label(below.unit) + "' do not go together",
           unit_hint(ratio), place);
  }
}

/// The label of a force at a moment, as programs write that know no other.
bool is_si_at_rotation(const Unit& unit, const DofRecord& dof) { return unit.si == 1.0 && dof.is_rotation(); }

void read_denominator(const Header58& header, const Place& place, LabelledUnits& read) {
  const auto unit = stated_unit(header.denominator.unit, "record 10", place);
  if (!unit || read.ratio) return;
  const int length = header.reference.is_rotation() ? 1 : 0;
  if (unit->same_dimension({1.0, length, 0, 1})) {
    read.denominator = unit->si;
  } else if (!is_si_at_rotation(*unit, header.reference) || unit->force != 1) {
    refuse("record 10",
           "unit '" + shown_label(header.denominator.unit) + "' is not one of a " + (length == 1 ? "moment" : "force"), {},
           place);
  }
}

void read_numerator(const Header58& header, const Place& place, LabelledUnits& read) {
  const auto unit = stated_unit(header.numerator.unit, "record 9", place);
  if (!unit) return;
  const int motion_length = header.response.is_rotation() ? 0 : 1;
  const int load_length = header.reference.is_rotation() ? 1 : 0;
  const auto quantity = quantity_of_time_exponent(unit->time);
  const bool motion = unit->force == 0 && unit->length == motion_length;
  read.ratio = quantity && unit->force == -1 && unit->length == motion_length - load_length;
  if (quantity && (motion || read.ratio)) {
    read.quantity = quantity;
    read.numerator = unit->si;
    if (read.ratio) read.denominator = 1.0;
  } else if (!quantity || unit->force > 0 || header.response.is_rotation() || !is_si_at_rotation(*unit, header.reference)) {
    refuse("record 9",
           "unit '" + shown_label(header.numerator.unit) + "' is not one of a " +
               (motion_length == 1 ? "translation" : "rotation") + ", its velocity or acceleration (" + header.response.name() + ")",
           {}, place);
  }
}

LabelledUnits read_labels(const Header58& header, const Place& place) {
  LabelledUnits read;
  read_numerator(header, place, read);
  read_denominator(header, place, read);
  require_together(header.numerator, header.denominator, place);
  return read;
}

Quantity quantity_of_motion(int type) {
  if (type == type_displacement) return Quantity::receptance;
  return type == type_velocity ? Quantity::mobility : Quantity::accelerance;
}

std::optional<Quantity> quantity_of_types(const Header58& header, const Place& place) {
  const int above = header.numerator.data_type;
  const int below = header.denominator.data_type;
  const bool motion = is_motion(above);
  if ((!motion && above > 1) || (!is_force_type(below) && below > 1)) {
    place.fail("records 9 and 10",
               "an FRF of data type " + std::to_string(above) + " over " + std::to_string(below) +
                   " is not displacement (8), velocity (11) or acceleration (12) over a force (13 or 9)",
               "export receptances, mobilities or accelerances");
  }
  return motion && is_force_type(below) ? std::optional(quantity_of_motion(above)) : std::nullopt;
}

/// By the labels, where one of the data types does not say it: they say motion, or the type of the numerator does, and they or
/// the type of the denominator say force.
std::optional<Quantity> quantity_of_labels(const LabelledUnits& labels, const Header58& header) {
  if (!labels.quantity || (!labels.denominator && !is_force_type(header.denominator.data_type))) return std::nullopt;
  return is_motion(header.numerator.data_type) ? quantity_of_motion(header.numerator.data_type) : *labels.quantity;
}

Quantity resolve_quantity(std::optional<Quantity> types, std::optional<Quantity> label, std::optional<Quantity> given,
                          const Header58& header, const Place& place) {
  if (given) return *given;
  if (!types) {
    place.fail("records 9 and 10",
               "data types " + std::to_string(header.numerator.data_type) + " and " +
                   std::to_string(header.denominator.data_type) + " do not state which quantity the FRF is",
               give_quantity);
  }
  if (label && label != types) {
    place.fail("record 9",
               "data type " + std::to_string(header.numerator.data_type) + " makes it " + name(*types) + " but its unit '" +
                   header.numerator.unit + "' makes it " + name(*label),
               give_quantity);
  }
  return *types;
}

/// The label of record 9 is of another quantity than the user says: its force holds, its motion is not used.
void drop_motion(LabelledUnits& labels, const Header58& header, Quantity given, const Place& place) {
  if (labels.numerator != 1.0) {
    place.fail(
        "record 9",
        "its unit '" + shown_label(header.numerator.unit) + "' is one of " + name(*labels.quantity) + ", and " + name(given) +
            " is given, and the file does not state the unit of its numbers",
        "give the unit, too: unit = \"" + unit(given) + "\" under [data.files.\"NAME\"] in the scene, or --unit of the command");
  }
  labels.numerator.reset();
  if (labels.ratio) labels.denominator.reset();
}

/// The SI unit of a record, where the user gives that of translations for a whole file with rotations; else what is given.
std::string unit_at(const Header58& header, const std::string& given) {
  const auto unit = parse_unit(given);
  const auto quantity = unit ? quantity_of_time_exponent(unit->time) : std::nullopt;
  if (!quantity || unit->si != 1.0 || !unit->same_dimension({1.0, 1, unit->time, -1})) return given;
  return si_unit(*quantity, header.response.dof(), header.reference.dof());
}

/// With the unit that the user gives in place of the labels.
Header58 with_unit(const Header58& header, const std::string& unit, const Place& place) {
  Header58 said = header;
  said.numerator.unit = unit_at(header, unit);
  said.denominator.unit.clear();
  LabelledUnits read;
  read_numerator(said, place, read);
  if (!read.ratio) {
    place.fail("record 9",
               "the unit '" + shown_label(unit) + "' that is given is not one of " + said.response.name() + " over " +
                   said.reference.name(),
               "give that of motion over force, e.g. m/(s^2*N) or g/lbf");
  }
  return said;
}

Ordinate interpret_labelled(const Header58& header, const UnitFactors& factors, std::optional<Quantity> given,
                            const Place& place) {
  auto types = quantity_of_types(header, place);
  LabelledUnits labels = read_labels(header, place);
  Ordinate ordinate;
  if (!types) types = quantity_of_labels(labels, header);
  ordinate.quantity = resolve_quantity(types, labels.quantity, given, header, place);
  ordinate.stated = types ? types : labels.quantity;
  if (labels.quantity && labels.quantity != ordinate.quantity) drop_motion(labels, header, ordinate.quantity, place);
  if ((!labels.numerator || !labels.denominator) && !factors.contradiction.empty()) {
    const std::string what = labels.numerator ? "the force" : "the motion";
    place.fail("records 9 and 10", "no unit of " + what + ", and " + factors.contradiction,
               "correct dataset 164, or " + std::string(give_unit));
  }
  const double motion = header.response.is_rotation() ? 1.0 : 1.0 / factors.length;
  const double load = (header.reference.is_rotation() ? 1.0 / factors.length : 1.0) / factors.force;
  ordinate.to_si = labels.numerator.value_or(motion) / labels.denominator.value_or(load);
  return ordinate;
}

}  // namespace

bool may_be_motion_over_force(const Header58& header) {
  const int above = header.numerator.data_type, below = header.denominator.data_type;
  if ((!is_motion(above) && above > 1) || (!is_force_type(below) && below > 1)) return false;
  if (above > 1 || parse_unit(header.numerator.unit)) return true;
  const std::string hint = unit_hint(header.numerator.unit);
  return !hint.ends_with("is a pressure") && !hint.ends_with("is a strain") && !hint.ends_with("is a temperature");
}

std::string quantity_in_words(const Header58& header) {
  const std::string above = data_type_name(header.numerator.data_type);
  return header.denominator.data_type == 0 ? above : above + " / " + data_type_name(header.denominator.data_type);
}

Ordinate interpret_ordinate(const Header58& header, const UnitFactors& factors, const GivenUnits& given, const Place& place) {
  if (given.unit.empty()) return interpret_labelled(header, factors, given.quantity, place);
  return interpret_labelled(with_unit(header, given.unit, place), factors, given.quantity, place);
}

std::optional<bool> spectrum_of_forces(const Header58& header) {
  if (header.numerator.data_type > 1) return is_force_type(header.numerator.data_type);
  const auto unit = parse_unit(header.numerator.unit);
  return unit ? std::optional(unit->force == 1) : std::nullopt;
}

Ordinate interpret_spectrum(const Header58& header, const UnitFactors& factors, const GivenUnits& given, const Place& place) {
  Header58 motion = header;
  if (!given.unit.empty())
    place.fail("record 9", "the unit '" + shown_label(given.unit) + "' is given, and this is a spectrum, no FRF", "leave it out");
  if (spectrum_of_forces(header).value_or(false)) {
    const int turns = header.response.is_rotation() ? 1 : 0;
    const auto unit = stated_unit(motion.numerator.unit, "record 9", place);
    const bool fits = unit && unit->same_dimension({1.0, turns, 0, 1});
    if (unit && !fits && !is_si_at_rotation(*unit, header.response))
      refuse("record 9", "unit '" + shown_label(motion.numerator.unit) + "' is not one of a " + (turns == 1 ? "moment" : "force"),
             {}, place);
    return {.to_si = fits ? unit->si : (turns == 1 ? 1.0 / factors.length : 1.0) / factors.force};
  }
  // That of the same motion over 1 N.
  motion.denominator = {.data_type = type_force, .unit = "N"};
  motion.reference.direction = static_cast<int>(Direction::x);
  return interpret_labelled(motion, factors, given.quantity, place);
}

double abscissa_to_hz(const Header58& header, const Place& place) {
  if (header.abscissa.data_type > 1 && header.abscissa.data_type != type_frequency) {
    place.fail("record 8", "abscissa of data type " + std::to_string(header.abscissa.data_type) + " is not a frequency (18)",
               std::string("export FRFs over frequency") +
                   (header.abscissa.data_type == type_rpm ? ", or give --frequency-unit rpm, in a scene frequency_unit" : ""));
  }
  try {
    return hertz_per(header.abscissa.unit).value_or(1.0);
  } catch (const InputError& error) {
    place.fail("record 8", error.parts().problem,
               error.parts().remedy + "; or give the unit of the axis: --frequency-unit, in a scene frequency_unit");
  }
}

}  // namespace jointid::frf::uff
