#include "laws/data/level_records.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/complex.hpp"
#include "base/error.hpp"
#include "base/statistics.hpp"
#include "base/text.hpp"

namespace jointid::laws {
namespace {

using records::OrderPhasors;

[[noreturn]] void fail(const records::Record& record, std::string place, std::string problem, std::string remedy) {
  throw InputError({ErrorKind::data, record.file, std::move(place), std::move(problem), std::move(remedy)});
}

/// The channel of a coordinate, a force or a motion, or none.
std::optional<std::size_t> channel_of(const records::Record& record, const frf::Dof& dof, bool force) {
  for (std::size_t c = 0; c < record.channels.size(); ++c) {
    const records::Channel& channel = record.channels[c];
    if (channel.dof.same_coordinate(dof) && (channel.kind == records::ChannelKind::force) == force) return c;
  }
  return std::nullopt;
}

std::string channels_text(const records::Record& record) {
  return comma_list(record.channels,
                    [](const records::Channel& channel) { return name(channel.kind) + " " + channel.dof.name(); });
}

void require_forces(const records::Record& record, const ForceLevel& level) {
  for (const frf::Dof& dof : level.force_dofs) {
    if (channel_of(record, dof, true)) continue;
    fail(record, "force_dofs " + dof.name(), "no channel is a force there; there are " + channels_text(record),
         "give the channel of the force its DOF and unit in channels, e.g. \"1=" + dof.name() + " N\"");
  }
}

/// What makes a displacement of a motion at this frequency.
Complex to_displacement(records::ChannelKind kind, double omega) {
  const Complex rate(0.0, omega);
  if (kind == records::ChannelKind::velocity) return 1.0 / rate;
  return kind == records::ChannelKind::acceleration ? 1.0 / (rate * rate) : Complex(1.0);
}

/// One harmonic of all lines of a level, being filled.
struct Filled {
  Filled(std::size_t lines, std::size_t dofs) : values(at(lines), at(dofs)), variances(at(lines), at(dofs)) {
    values.setConstant(Complex(nan, nan));
    variances.setZero();
  }
  Eigen::MatrixXcd values;
  Eigen::MatrixXd variances;
};

}  // namespace

LevelRecordings::LevelRecordings(const ForceLevel& level) : level_(level) {
  for (const ident::Path& file : level.records->files) {
    for (records::Record& record : records::read_records(file, level.records->options)) {
      require_forces(record, level);
      std::vector<frf::Dof> own;
      for (const std::size_t c : records::motion_channels(record)) own.push_back(record.channels[c].dof);
      if (records_.empty()) dofs_ = own;
      std::erase_if(dofs_, [&](const frf::Dof& dof) { return !frf::has(own, dof); });
      records_.push_back(level.records->sweep ? records::from_common_start(record) : std::move(record));
    }
  }
  if (!level.records->lines_hz.empty() && records_.size() != level.records->lines_hz.size())
    fail(records_.front(), "lines",
         fmt::format("{} lines for {} records of the files", level.records->lines_hz.size(), records_.size()),
         "give one for each record, or none: they are found");
}

LevelRecordings::Lines LevelRecordings::lines_of(const std::vector<double>& parts_hz) {
  const LevelRecords& how = *level_.records;
  records::OrderOptions options;
  options.settle_s = how.settle_s;
  options.periods = how.periods;
  options.harmonics.clear();
  for (const HarmonicFiles& each : level_.harmonics) options.harmonics.push_back(each.harmonic);
  constexpr double most_off = 2e-4;
  Lines lines;
  const auto add = [&](OrderPhasors phasors, std::size_t record) {
    const auto nearest = std::ranges::min_element(parts_hz, {}, [&](double hz) { return std::abs(hz - phasors.frequency_hz); });
    if (nearest == parts_hz.end() || std::abs(*nearest - phasors.frequency_hz) > most_off * phasors.frequency_hz) {
      notes_.push_back(fmt::format("{}: left out: the force of {} has {:.7g} Hz, of which the parts have no line{}", level_.name,
                                   records_[record].file, phasors.frequency_hz,
                                   nearest == parts_hz.end() ? "" : fmt::format(" (the nearest is {:.7g} Hz)", *nearest)));
      return;
    }
    if (!lines.try_emplace(*nearest, Source{std::move(phasors), record}).second) {
      notes_.push_back(
          fmt::format("{}: left out: the force of {} has {:.7g} Hz again", level_.name, records_[record].file, *nearest));
    }
  };
  for (std::size_t r = 0; r < records_.size(); ++r) {
    if (how.sweep) {
      for (OrderPhasors& each : records::sweep_phasors(records_[r], parts_hz, options)) add(std::move(each), r);
    } else {
      options.frequency_hz = how.lines_hz.empty() ? std::nullopt : std::optional(how.lines_hz[r]);
      add(records::steady_phasors(records_[r], options), r);
    }
  }
  if (how.sweep && !lines.empty()) judge_sweep(lines);
  return lines;
}

void LevelRecordings::judge_sweep(const Lines& lines) {
  constexpr double much = 0.1;
  double window = 0.0, lag = 0.0;
  for (const auto& [hz, source] : lines) {
    window = std::max(window, source.phasors.window_bias);
    lag = std::max(lag, source.phasors.lag_bias);
  }
  notes_.push_back(
      fmt::format("{}: windows of {} periods of a sweep: phasors off by {:.2g} % at most for the window, {:.2g} % for the lag "
                  "behind the steady response",
                  level_.name, level_.records->periods, 100.0 * window, 100.0 * lag));
  if (std::max(window, lag) > much)
    fail(records_.front(), "sweep",
         fmt::format("it is too fast: a phasor is off by {:.2g} % for the window, {:.2g} % for the lag", 100.0 * window, 100.0 * lag),
         "sweep more slowly, or take fewer periods where the window leads");
}

LevelRecordings::Harmonic LevelRecordings::harmonic(std::size_t n, const Lines& lines, const std::vector<frf::Dof>& responses) const {
  const int number = level_.harmonics[n].harmonic;
  Phasors motion, force;
  Filled motions(lines.size(), responses.size()), forces(lines.size(), level_.force_dofs.size());
  Eigen::Index line = 0;
  for (const auto& entry : lines) {
    const double hz = entry.first;
    const Source& source = entry.second;
    const records::Record& record = records_[source.record];
    motion.file = force.file = record.file;
    motion.frequency_hz.push_back(number * hz);
    const double force_start = record.channels[records::force_channels(record).front()].start_s;
    const auto put = [&](const frf::Dof& dof, bool is_force, Eigen::Index column, Filled& to) {
      const auto c = channel_of(record, dof, is_force);
      if (!c) return;
      const records::Channel& channel = record.channels[*c];
      const double late = channel.start_s - force_start;
      const Complex factor = (channel.dof == dof ? 1.0 : -1.0) * std::polar(1.0, -angular(number * hz) * late) *
                             (is_force ? Complex(1.0) : to_displacement(channel.kind, angular(number * hz)));
      to.values(line, column) = factor * source.phasors.value(at(n), at(*c));
      to.variances(line, column) = std::norm(factor) * std::pow(source.phasors.deviation(at(n), at(*c)), 2);
    };
    for (std::size_t i = 0; i < responses.size(); ++i) put(responses[i], false, at(i), motions);
    for (std::size_t i = 0; i < level_.force_dofs.size(); ++i) put(level_.force_dofs[i], true, at(i), forces);
    ++line;
  }
  force.frequency_hz = motion.frequency_hz;
  motion.values = std::move(motions.values);
  motion.variances = std::move(motions.variances);
  force.values = std::move(forces.values);
  force.variances = std::move(forces.variances);
  return {std::make_shared<const Phasors>(std::move(motion)), std::make_shared<const Phasors>(std::move(force))};
}

std::vector<LevelRecordings::Harmonic> LevelRecordings::phasors(const std::vector<frf::Dof>& responses,
                                                                const std::vector<double>& parts_hz) {
  const Lines lines = lines_of(parts_hz);
  std::vector<Harmonic> out;
  for (std::size_t n = 0; n < level_.harmonics.size(); ++n) out.push_back(harmonic(n, lines, responses));
  return out;
}

}  // namespace jointid::laws
