#include "gui/records/record_preview.hpp"

#include <algorithm>

#include "base/control.hpp"
#include "gui/look/said.hpp"
#include "records/file/open_samples.hpp"
#include "report/decimate.hpp"

namespace jointid::gui {
namespace {

constexpr std::size_t most_samples = std::size_t{1} << 18, most_drawn = 4000, in_a_plot = 4;

/// A column a channel; that of times first, where the file has one.
struct Samples {
  std::vector<records::StreamChannel> channels;
  std::vector<std::vector<double>> columns;
  bool has_times = false;
};

Samples read_samples(const std::filesystem::path& file, const std::function<bool()>& interrupted) {
  constexpr std::size_t rows_at_once = 4096;
  auto stream = records::open_samples(file);
  Samples out;
  out.has_times = !stream->time_column().empty();
  if (out.has_times) {
    records::StreamOptions options{{stream->time_column()}, 0, 1};
    for (const auto& channel : stream->channels()) options.channels.push_back(channel.name);
    stream = records::open_samples(file, options);
  }
  out.channels = stream->channels();
  out.columns.resize(out.channels.size());
  std::vector<double> block(rows_at_once * out.channels.size());
  while (out.columns.front().size() < most_samples) {
    stop_if(interrupted);
    const std::size_t rows = stream->read(block);
    if (rows == 0) break;
    for (std::size_t i = 0; i < rows; ++i) {
      for (std::size_t k = 0; k < out.columns.size(); ++k) out.columns[k].push_back(block[i * out.columns.size() + k]);
    }
  }
  if (!out.has_times) {
    const std::optional<double> rate_hz = stream->rate_hz();
    out.has_times = rate_hz.has_value();
    std::vector<double> axis(out.columns.front().size());
    for (std::size_t i = 0; i < axis.size(); ++i)
      axis[i] = rate_hz ? static_cast<double>(i) / *rate_hz : static_cast<double>(i + 1);
    out.columns.insert(out.columns.begin(), std::move(axis));
    out.channels.insert(out.channels.begin(), {"", "s"});
  }
  return out;
}

report::CurvePlot plot_of(const Samples& samples, std::size_t channel) {
  const std::vector<std::size_t> kept = report::keep_peaks({&samples.columns[channel], 1}, most_drawn);
  const auto& [name, unit] = samples.channels[channel];
  report::CurvePlot plot;
  const std::string& second = samples.channels.front().unit;
  plot.x = {samples.has_times ? "time (" + (second.empty() ? "s" : second) + ")" : "sample", false};
  plot.y = {unit.empty() ? name : name + " (" + unit + ")", false};
  report::Series series{name, {}, report::Style::line};
  for (const std::size_t row : kept) {
    plot.x_values.push_back(samples.columns[0][row]);
    series.y.push_back(samples.columns[channel][row]);
  }
  plot.series.push_back(std::move(series));
  return plot;
}

}  // namespace

report::PlotGroup record_preview(const std::filesystem::path& file, const std::function<bool()>& interrupted) {
  const Samples samples = read_samples(file, interrupted);
  report::PlotGroup group{"record", {}};
  for (std::size_t first = 1; first < samples.columns.size(); first += in_a_plot) {
    const std::size_t last = std::min(samples.columns.size(), first + in_a_plot) - 1;
    report::Choice choice;
    choice.name =
        first == last ? samples.channels[first].name : samples.channels[first].name + " … " + samples.channels[last].name;
    for (std::size_t channel = first; channel <= last; ++channel) choice.plots.push_back(plot_of(samples, channel));
    group.choices.push_back(std::move(choice));
  }
  return group;
}

}  // namespace jointid::gui
