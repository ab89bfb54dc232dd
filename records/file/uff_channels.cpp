#include "records/file/uff_channels.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "frf/uff/uff58_data.hpp"
#include "frf/uff/uff_geometry.hpp"
#include "frf/uff/uff_units.hpp"
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

struct Ordinate {
  std::optional<ChannelKind> kind = {};
  double to_si = 1.0;
  std::string unit;
};

/// Without a kind where the record is neither force nor motion.
Ordinate interpret(const Header58& header, const frf::uff::UnitFactors& factors) {
  const bool rotation = header.response.is_rotation();
  const auto unit = frf::uff::parse_label(header.numerator.unit);
  const auto labelled = unit ? kind_of(*unit, rotation) : std::nullopt;
  const auto typed = kind_of_type(header.numerator.data_type);
  if (!typed && !labelled) return {{}, 1.0, header.numerator.unit == "NONE" ? "" : header.numerator.unit};
  const ChannelKind kind = typed.value_or(labelled.value_or(ChannelKind::force));
  if (labelled == kind) return {kind, unit->si, si_unit(kind, rotation)};
  const bool force = kind == ChannelKind::force;
  const double length = force == rotation ? 1.0 / factors.length : 1.0;
  return {kind, force ? length / factors.force : length, si_unit(kind, rotation)};
}

/// Of a channel without direction.
std::string scalar_name(const Header58& header) {
  return header.id[0].empty() || header.id[0] == "NONE" ? header.response.name() : header.id[0];
}

bool same_channel(const UffChannel& one, const UffChannel& other) {
  if (one.kind && other.kind) return one.kind == other.kind && one.dof.same_coordinate(other.dof);
  return one.name == other.name && one.unit == other.unit;
}

double rate(const std::string& file, const Dataset& dataset, const std::vector<double>& abscissa) {
  const Header58& header = *dataset.function;
  if (header.abscissa.data_type > 1 && header.abscissa.data_type != frf::uff::type_time) {
    dataset.place.fail("record 8", fmt::format("abscissa of data type {} is not a time (17)", header.abscissa.data_type),
                       "export time records");
  }
  const std::string& unit = header.abscissa.unit;
  const auto label = frf::uff::parse_label(unit);
  const double to_s = unit == "ms"                                                           ? 1e-3
                      : label && label->time == 1 && label->length == 0 && label->force == 0 ? label->si
                                                                                             : 1.0;
  std::vector<double> times =
      header.even ? std::vector{header.abscissa_first, header.abscissa_first + header.abscissa_step} : abscissa;
  for (double& time : times) time *= to_s;
  return rate_of(times, file, fmt::format("{}, abscissa", dataset.place.dataset));
}

void require_force_or_motion(const Dataset& dataset, const Ordinate& ordinate) {
  const Header58& header = *dataset.function;
  if (header.response.direction == 0) {
    dataset.place.fail("record 6", "response node " + std::to_string(header.response.node) + " has no direction",
                       "export nodes and directions");
  }
  if (!ordinate.kind) {
    dataset.place.fail(
        "record 9", fmt::format("data type {} in '{}' is no force or motion", header.numerator.data_type, header.numerator.unit),
        "export displacement (8), velocity (11), acceleration (12) or force (13)");
  }
}

UffChannel channel_of(frf::uff::ByteFile& file, const Dataset& dataset, const frf::uff::UnitFactors& factors,
                      UffQuantities quantities) {
  const Header58& header = *dataset.function;
  frf::uff::require_readable(dataset);
  frf::uff::require_plausible_size(file, dataset);
  if (header.is_complex()) dataset.place.fail("record 7", "a time response with complex values", "export it as real numbers");
  const Ordinate ordinate = interpret(header, factors);
  if (quantities == UffQuantities::forces_and_motions) require_force_or_motion(dataset, ordinate);
  if (header.response.direction == 0) return {scalar_name(header), {}, {}, ordinate.to_si, ordinate.unit, dataset};
  return {header.response.name(), header.response.dof(), ordinate.kind, ordinate.to_si, ordinate.unit, dataset};
}

}  // namespace

double UffChannel::rate_hz(const std::string& file, const std::vector<double>& abscissa) const {
  return rate(file, dataset, abscissa);
}

std::vector<std::vector<UffChannel>> uff_runs(frf::uff::ByteFile& file, UffQuantities quantities) {
  const std::vector<Dataset> datasets = frf::uff::scan(file);
  const frf::uff::UnitTable units(file, datasets);
  std::vector<std::vector<UffChannel>> runs;
  for (const Dataset& dataset : datasets) {
    if (!dataset.function || dataset.function->function_type != function_time) continue;
    UffChannel channel = channel_of(file, dataset, units.at(dataset), quantities);
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
