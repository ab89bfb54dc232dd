#include "records/file/uff_channels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/error.hpp"
#include "frf/set/unit_label.hpp"
#include "frf/uff/uff58_data.hpp"
#include "frf/uff/uff_unit_table.hpp"
#include "records/file/time_axis.hpp"

namespace jointid::records {
namespace {

using frf::uff::Dataset;
using frf::uff::Header58;

constexpr int function_time = 1;

std::optional<ChannelKind> kind_of_type(int type) {
  switch (type) {
    case frf::uff::type_displacement:
      return ChannelKind::displacement;
    case frf::uff::type_velocity:
      return ChannelKind::velocity;
    case frf::uff::type_acceleration:
      return ChannelKind::acceleration;
    case frf::uff::type_force:
    case frf::uff::type_reaction_force:
      return ChannelKind::force;
    default:
      return std::nullopt;
  }
}

std::string si_unit(ChannelKind kind, bool rotation) {
  switch (kind) {
    case ChannelKind::force:
      return rotation ? "N m" : "N";
    case ChannelKind::displacement:
      return rotation ? "rad" : "m";
    case ChannelKind::velocity:
      return rotation ? "rad/s" : "m/s";
    case ChannelKind::acceleration:
      break;
  }
  return rotation ? "rad/s^2" : "m/s^2";
}

/// Stress, strain, temperature, heat flux, pressure, mass, frequency, revolutions.
bool is_of_another_quantity(int type) {
  constexpr std::array types = {2, 3, 5, 6, 15, 16, 18, 19};
  return std::ranges::find(types, type) != types.end();
}

bool has_direction(const Header58& header) { return header.response.direction != 0; }

/// The kind of force or motion that a record is of, and the factor to SI; or why it is none.
void interpret(const Header58& header, const frf::uff::UnitFactors& factors, bool has_factors, UffChannel& out) {
  const bool rotation = header.response.is_rotation();
  const std::string& label = header.numerator.unit;
  const bool says_nothing = frf::states_no_unit(label);
  const auto unit = frf::parse_unit(label);
  const auto labelled = unit ? kind_of(*unit, rotation) : std::nullopt;
  const auto typed = kind_of_type(header.numerator.data_type);
  const int type = header.numerator.data_type;
  out.stated = says_nothing ? std::string() : frf::shown_label(label);
  out.unit = out.stated;
  if (labelled && (typed ? typed == labelled : !is_of_another_quantity(type))) {
    out.kind = labelled, out.to_si = unit->si, out.unit = si_unit(*labelled, rotation);
    return;
  }
  if (typed && says_nothing && !factors.contradiction.empty()) {
    out.problem = "it has no unit, and " + factors.contradiction;
    return;
  }
  if (typed && says_nothing && !has_factors && !header.doubt.empty()) {
    out.problem = "it has no unit, and " + header.doubt;
    return;
  }
  if (typed && says_nothing) {
    const bool force = *typed == ChannelKind::force;
    const double length = force == rotation ? 1.0 / factors.length : 1.0;
    out.kind = typed, out.to_si = force ? length / factors.force : length, out.unit = si_unit(*typed, rotation);
    if (has_factors) out.stated = fmt::format("the units of dataset 164 ({:g} {})", out.to_si, out.unit);
    return;
  }
  const std::string hint = frf::unit_hint(label),
                    of = typed && unit ? fmt::format(", which is {},", name(*typed)) : std::string();
  out.problem = fmt::format("data type {}{} in '{}' is no force or motion{}", type, of, out.stated,
                            has_direction(header) ? " at " + header.response.name() : std::string());
  if (!hint.empty()) out.problem += " (" + hint + ")";
}

/// Of a channel without direction.
std::string scalar_name(const Header58& header) {
  return header.id[0].empty() || header.id[0] == "NONE" ? header.response.name() : header.id[0];
}

bool same_channel(const UffChannel& one, const UffChannel& other) {
  if (one.dof && other.dof && one.kind && other.kind) return one.kind == other.kind && one.dof->same_coordinate(*other.dof);
  return one.dof.has_value() == other.dof.has_value() && one.name == other.name && one.unit == other.unit;
}

UffChannel channel_of(frf::uff::ByteFile& file, const Dataset& dataset, const frf::uff::UnitFactors& factors, bool has_factors) {
  const Header58& header = *dataset.function;
  frf::uff::require_readable(dataset);
  frf::uff::require_plausible_size(file, dataset);
  if (header.is_complex()) dataset.place.fail("record 7", "a time response with complex values", "export it as real numbers");
  UffChannel out{.name = has_direction(header) ? header.response.name() : scalar_name(header), .dataset = dataset};
  if (has_direction(header)) out.dof = header.response.dof();
  interpret(header, factors, has_factors, out);
  return out;
}

/// Seconds per unit of the abscissa; none where its label is not understood and `may_be_unknown`.
std::optional<double> seconds_per_unit(const Dataset& dataset, bool may_be_unknown) {
  const Header58& header = *dataset.function;
  if (header.abscissa.data_type > 1 && header.abscissa.data_type != frf::uff::type_time) {
    dataset.place.fail("record 8", fmt::format("abscissa of data type {} is not a time (17)", header.abscissa.data_type),
                       "export time records");
  }
  try {
    return frf::seconds_per(header.abscissa.unit).value_or(1.0);
  } catch (const InputError& error) {
    if (may_be_unknown) return std::nullopt;
    dataset.place.fail("record 8", error.parts().problem, error.parts().remedy + ", or give --rate (in a scene: rate)");
  }
}

}  // namespace

UffChannel::Times UffChannel::times(const std::string& file, const std::vector<double>& abscissa,
                                    std::optional<double> given_hz) const {
  const Header58& header = *dataset.function;
  const double first = header.even || abscissa.empty() ? header.abscissa_first : abscissa.front();
  const auto unit = seconds_per_unit(dataset, given_hz && first == 0.0);
  const std::string place = fmt::format("{}, abscissa", dataset.place.dataset);
  Times out{given_hz, unit.value_or(1.0) * first};
  if (!unit || (header.even && header.abscissa_step == 0.0)) return out;
  std::vector<double> seconds = header.even ? std::vector{0.0, header.abscissa_step} : abscissa;
  for (double& time : seconds) time *= *unit;
  if (given_hz && !header.even && !are_even(seconds)) return out;
  const double stated = rate_of(seconds, file, place);
  out.rate_hz = given_hz ? agreed_rate(stated, *given_hz, file, place) : stated;
  return out;
}

std::vector<std::vector<UffChannel>> uff_runs(frf::uff::ByteFile& file) {
  const std::vector<Dataset> datasets = frf::uff::scan(file);
  const frf::uff::UnitTable units(file, datasets);
  const bool has_factors = std::ranges::any_of(datasets, [](const Dataset& dataset) { return dataset.number == 164; });
  std::vector<std::vector<UffChannel>> runs;
  for (const Dataset& dataset : datasets) {
    if (!dataset.function || dataset.function->function_type != function_time) continue;
    UffChannel channel = channel_of(file, dataset, units.at(dataset), has_factors);
    const auto same = [&](const UffChannel& other) { return same_channel(channel, other); };
    if (runs.empty() || std::ranges::any_of(runs.back(), same)) runs.emplace_back();
    runs.back().push_back(std::move(channel));
  }
  if (runs.empty()) {
    throw InputError(
        {ErrorKind::data, file.name(), {}, "no time responses", "export the records as dataset 58 with function type 1"});
  }
  return runs;
}

}  // namespace jointid::records
