#include "records/file/uff_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "frf/uff/uff58_data.hpp"
#include "frf/uff/uff_geometry.hpp"
#include "frf/uff/uff_units.hpp"
#include "records/file/limits.hpp"
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

struct Ordinate {
  ChannelKind kind;
  double to_si;
};

Ordinate interpret(const Dataset& dataset, const frf::uff::UnitFactors& factors) {
  const Header58& header = *dataset.function;
  const bool rotation = header.response.is_rotation();
  const auto unit = frf::uff::parse_label(header.numerator.unit);
  const auto labelled = unit ? kind_of(*unit, rotation) : std::nullopt;
  const auto typed = kind_of_type(header.numerator.data_type);
  if (!typed && !labelled) {
    dataset.place.fail(
        "record 9", fmt::format("data type {} in '{}' is no force or motion", header.numerator.data_type, header.numerator.unit),
        "export displacement (8), velocity (11), acceleration (12) or force (13)");
  }
  const ChannelKind kind = typed.value_or(labelled.value_or(ChannelKind::force));
  if (labelled == kind) return {kind, unit->si};
  const bool force = kind == ChannelKind::force;
  const double length = force == rotation ? 1.0 / factors.length : 1.0;
  return {kind, force ? length / factors.force : length};
}

double rate(frf::uff::ByteFile& file, const Dataset& dataset, const std::vector<double>& abscissa) {
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
  return rate_of(times, file.name(), fmt::format("{}, abscissa", dataset.place.dataset));
}

class Runs {
 public:
  explicit Runs(frf::uff::ByteFile& file) : file_(file) {}

  void add(const Dataset& dataset, const frf::uff::UnitFactors& factors) {
    const Header58& header = *dataset.function;
    frf::uff::require_readable(dataset);
    frf::uff::require_plausible_size(file_, dataset);
    if (header.is_complex()) dataset.place.fail("record 7", "a time response with complex values", "export it as real numbers");
    if (header.response.direction == 0) {
      dataset.place.fail("record 6", "response node " + std::to_string(header.response.node) + " has no direction",
                         "export nodes and directions");
    }
    numbers_ += header.points;
    if (numbers_ > most_numbers)
      dataset.place.fail("record 7", "the file holds more than 268 million numbers", "export it in several files");
    const Ordinate ordinate = interpret(dataset, factors);
    const frf::uff::Points points = frf::uff::read_points(file_, dataset);
    Channel channel{header.response.name(), header.response.dof(), ordinate.kind, std::vector<double>(points.values.size())};
    std::ranges::transform(points.values, channel.samples.begin(), [&](Complex value) { return ordinate.to_si * value.real(); });
    put(std::move(channel), rate(file_, dataset, points.abscissa), dataset);
  }

  std::vector<Record> take() { return std::move(runs_); }

 private:
  void put(Channel channel, double rate_hz, const Dataset& dataset) {
    const auto same = [&](const Channel& other) { return other.kind == channel.kind && other.dof.same_coordinate(channel.dof); };
    if (runs_.empty() || std::ranges::any_of(runs_.back().channels, same)) runs_.push_back({file_.name(), rate_hz});
    Record& run = runs_.back();
    if (!run.channels.empty() &&
        (run.samples() != channel.samples.size() || std::abs(rate_hz - run.rate_hz) > 1e-6 * run.rate_hz)) {
      dataset.place.fail("record 7",
                         fmt::format("{} samples at {:g} Hz, the channels before have {} at {:g} Hz", channel.samples.size(),
                                     rate_hz, run.samples(), run.rate_hz),
                         "export channels of one run with one rate and length");
    }
    run.channels.push_back(std::move(channel));
  }

  frf::uff::ByteFile& file_;
  std::uint64_t numbers_ = 0;
  std::vector<Record> runs_;
};

}  // namespace

std::vector<Record> read_uff_records(const std::filesystem::path& path) {
  frf::uff::ByteFile file(path);
  const std::vector<Dataset> datasets = frf::uff::scan(file);
  const frf::uff::UnitTable units(file, datasets);
  Runs runs(file);
  for (const Dataset& dataset : datasets) {
    if (dataset.function && dataset.function->function_type == function_time) runs.add(dataset, units.at(dataset));
  }
  std::vector<Record> records = runs.take();
  if (records.empty()) {
    throw InputError(
        {ErrorKind::data, file.name(), {}, "no time responses", "export the records as dataset 58 with function type 1"});
  }
  return records;
}

}  // namespace jointid::records
