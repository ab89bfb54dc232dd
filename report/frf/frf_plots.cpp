#include "report/frf/frf_plots.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/statistics.hpp"
#include "records/estimate/window.hpp"
#include "report/decimate.hpp"
#include "report/frf_curves.hpp"

namespace jointid::report {
namespace {

const char* unit_of(const records::Channel& channel) {
  const bool turns = channel.dof.is_rotation();
  switch (channel.kind) {
    case records::ChannelKind::force: return turns ? "N·m" : "N";
    case records::ChannelKind::displacement: return turns ? "rad" : "m";
    case records::ChannelKind::velocity: return turns ? "rad/s" : "m/s";
    case records::ChannelKind::acceleration: break;
  }
  return turns ? "rad/s²" : "m/s²";
}

double largest_sample(const std::vector<double>& samples) {
  double most = 0.0;
  for (const double sample : samples) most = std::isfinite(sample) ? std::max(most, std::abs(sample)) : most;
  return most;
}

/// What the samples of a segment are multiplied with.
std::vector<double> window_of(const tasks::FrfRun& run, const records::Blow& blow, double rate_hz, bool of_force) {
  const records::FrfOptions& options = run.options;
  if (options.segments) return records::make_window(options.segments->window, blow.length);
  std::vector<double> out(blow.length, 1.0);
  const auto times = [&out](const std::vector<double>& window) {
    for (std::size_t i = 0; i < out.size(); ++i) out[i] *= window[i];
  };
  if (options.decay_time_s) times(records::exponential_window(blow.length, *options.decay_time_s, rate_hz));
  if (of_force && options.force_window_s && blow.peak)
    times(records::force_window(blow.length, *blow.peak - blow.first, *options.force_window_s, rate_hz));
  return out;
}

/// The windows of segments that are averaged, or only marks where others are, over a record; NaN elsewhere.
std::vector<double> segments_of(const tasks::FrfRun& run, std::size_t record, std::size_t samples, bool kept, bool force, double height) {
  std::vector<double> out(samples, nan);
  for (const records::Blow& blow : run.made.blows) {
    if (blow.record != record || blow.rejected.empty() != kept) continue;
    const std::vector<double> window = window_of(run, blow, run.rate_hz[record], force);
    for (std::size_t i = 0; i < blow.length && blow.first + i < samples; ++i) {
      double& at = out[blow.first + i];
      at = std::isnan(at) ? height * (kept ? window[i] : 1.0) : std::max(at, height * window[i]);
    }
  }
  return out;
}

CurvePlot trace(const tasks::FrfRun& run, const records::Record& record, std::size_t number, const records::Channel& channel,
                std::size_t most) {
  const bool is_force = channel.kind == records::ChannelKind::force;
  const double height = largest_sample(channel.samples);
  const std::size_t samples = channel.samples.size();
  const std::array curves = {channel.samples, segments_of(run, number, samples, true, is_force, height),
                             segments_of(run, number, samples, false, is_force, height)};
  const std::vector<std::size_t> kept = keep_peaks(curves, most);
  std::vector<double> times;
  for (const std::size_t i : kept) times.push_back(static_cast<double>(i) / record.rate_hz);
  CurvePlot plot{channel.name + " " + channel.dof.name(),
                 {"time (s)", false},
                 {channel.name + " (" + unit_of(channel) + ")", false},
                 std::move(times),
                 {{"record", picked(channel.samples, kept), Style::line}, {"averaged, window", picked(curves[1], kept), Style::dashed}},
                 {},
                 {},
                 {}};
  if (std::ranges::any_of(curves[2], [](double y) { return !std::isnan(y); }))
    plot.series.push_back({"left out", picked(curves[2], kept), Style::reference});
  return plot;
}

}  // namespace

Choice frf_choice(const tasks::FrfRun& run, std::size_t r, std::size_t c, std::size_t most) {
  const frf::FrfSet& set = run.made.set;
  std::vector<Complex> values;
  std::vector<double> coherence;
  for (std::size_t line = 0; line < set.header.lines(); ++line) {
    values.push_back(set.values[set.index(line, r, c)]);
    coherence.push_back(run.made.coherence[set.index(line, r, c)]);
  }
  const std::array both = {magnitudes(values), coherence};
  const std::vector<std::size_t> kept = keep_peaks(both, most);
  const std::string name = set.header.response[r].name() + " / " + set.header.reference[c].name();
  const auto plot = [&](const std::string& title, Axis y, std::size_t which) {
    return CurvePlot{title,
                     {"frequency (Hz)", false},
                     std::move(y),
                     picked(set.header.frequency_hz, kept),
                     {{"measured", picked(both[which], kept), Style::line}},
                     {},
                     {},
                     {}};
  };
  CurvePlot of_coherence = plot("Coherence", {"coherence", false}, 1);
  of_coherence.y_range = {0.0, 1.05};
  return {
      name,
      {plot("Magnitude of " + name, {receptance_label(set.header.response[r], set.header.reference[c]), true}, 0), of_coherence}};
}

PlotGroup frf_plots(const tasks::FrfRun& run, std::size_t most_choices, std::size_t most) {
  const frf::FrfHeader& header = run.made.set.header;
  PlotGroup group{"FRF", {}};
  for (std::size_t e = 0; e < std::min(header.entries(), most_choices); ++e)
    group.choices.push_back(frf_choice(run, e % header.response.size(), e / header.response.size(), most));
  return group;
}

PlotGroup trace_plots(const tasks::FrfRun& run, const std::vector<records::Record>& records, std::size_t most) {
  PlotGroup group{"Record", {}};
  for (std::size_t number = 0; number < records.size(); ++number) {
    const records::Record& record = records[number];
    Choice choice{run.record_files[number], {}};
    for (const records::Channel& channel : record.channels) choice.plots.push_back(trace(run, record, number, channel, most));
    group.choices.push_back(std::move(choice));
  }
  return group;
}

}  // namespace jointid::report
