#include "tasks/series/delay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/control.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "oscillation/delay/checked_series.hpp"
#include "tasks/tell.hpp"

namespace jointid::tasks {
namespace {

constexpr double few_false = 0.01;       ///< share of false neighbours that is allowed for noise
constexpr std::size_t most_periods = 8;  ///< recurrent periods that are told

records::SeriesRecord read_channel(const DelayTask& task) {
  records::SeriesOptions options{{}, task.rate_hz, task.samples};
  if (!task.channel.empty()) options.channels = {task.channel};
  records::SeriesRecord record = records::read_series(task.file, options);
  if (record.channels.size() > 1) {
    const std::string names = comma_list(record.channels, [](const auto& channel) { return channel.name; });
    throw InputError({ErrorKind::usage, record.file, "--channel", "the file has the channels " + names, "name one of them"});
  }
  return record;
}

std::size_t dimension_of(const std::vector<oscillation::FalseNeighbours>& rows) {
  const auto few = std::ranges::find_if(rows, [](const auto& row) { return row.either <= few_false; });
  return few == rows.end() ? 0 : few->dimension;
}

/// One after another, watched.
class DelayRun {
 public:
  DelayRun(const DelayTask& task, const ident::Control& control) : task_(task), control_(control) {}

  DelayResult run(const records::SeriesRecord& record) {
    x_ = record.samples.front();
    out_.file = record.file, out_.channel = record.channels.front().name, out_.unit = record.channels.front().unit;
    out_.rate_hz = record.rate_hz, out_.samples = x_.size();
    if (record.is_cut) out_.remarks.push_back(fmt::format("the first {} samples are used; --samples takes more", x_.size()));
    step("mutual information", [&] { find_delay(); });
    step("false neighbours", [&] { find_dimension(); });
    step("correlation dimension", [&] { out_.correlation = oscillation::correlation_dimension(x_, out_.embedding, out_.theiler); });
    const oscillation::DivergenceOptions divergence{out_.embedding, out_.theiler, task_.steps, 1.0 / out_.rate_hz};
    step("exponent by Rosenstein", [&] { out_.rosenstein = oscillation::largest_exponent_rosenstein(x_, divergence); });
    step("exponent by Kantz", [&] { out_.kantz = oscillation::largest_exponent_kantz(x_, divergence); });
    if (!task_.wolf.empty()) step("exponent by Wolf", [&] { find_wolf(); });
    step("recurrences", [&] { find_recurrences(); });
    return std::move(out_);
  }

 private:
  template <class Work>
  void step(const char* stage, const Work& work) {
    tell(control_, stage);
    stop_if(control_.interrupted);
    work();
  }

  void find_delay() {
    const std::size_t most = std::min(task_.most_lag, x_.size() / 4);
    out_.information = oscillation::information_curve(x_, most, {task_.cells, false});
    out_.information_bias = oscillation::information_bias(task_.cells, x_.size());
    out_.delay_given = task_.delay > 0;
    if (out_.delay_given) {
      out_.embedding.delay = task_.delay;
    } else if (out_.information.first_minimum) {
      out_.embedding.delay = *out_.information.first_minimum;
    } else {
      out_.embedding.delay = 1;
      out_.remarks.push_back(fmt::format(
          "the mutual information has no minimum up to lag {}: a delay of 1 is used; give --delay or --most-lag", most));
    }
  }

  void find_dimension() {
    const std::size_t window =
        task_.theiler > 0 ? task_.theiler : 2 * out_.embedding.delay * std::max<std::size_t>(task_.dimension, 3);
    out_.theiler = window;
    out_.neighbours = oscillation::false_neighbours(x_, {out_.embedding.delay, task_.most_dimension, window, 10.0, 2.0});
    out_.dimension_given = task_.dimension > 0;
    out_.embedding.dimension = out_.dimension_given ? task_.dimension : dimension_of(out_.neighbours);
    if (out_.embedding.dimension == 0) {
      out_.embedding.dimension = task_.most_dimension;
      out_.remarks.push_back(
          fmt::format("more than 1 % of the neighbours are false in all dimensions up to {}: noise, or a larger dimension",
                      task_.most_dimension));
    }
  }

  void find_wolf() {
    constexpr double near = 0.001, far = 0.1;  // of the standard deviation: beyond the noise, within a fold
    const double sigma = oscillation::deviation(x_);
    out_.wolf_range = task_.wolf_range.value_or(std::array{near * sigma, far * sigma});
    for (const std::size_t evolve : task_.wolf) {
      out_.wolf.push_back({evolve, oscillation::wolf_exponent(x_, {.embedding = out_.embedding,
                                                              .theiler = out_.theiler,
                                                              .evolve = evolve,
                                                              .smallest = out_.wolf_range[0],
                                                              .largest = out_.wolf_range[1],
                                                              .sample_time = 1.0 / out_.rate_hz})});
    }
  }

  void find_recurrences() {
    const RowMatrixXd points = oscillation::delay_points(x_, out_.embedding);
    out_.recurrence_radius = oscillation::half_mean_step(points);
    out_.recurrences = oscillation::recurrent_periods(oscillation::recurrences(points, out_.recurrence_radius), out_.embedding.delay);
    out_.recurrences.resize(std::min(out_.recurrences.size(), most_periods));
  }

  const DelayTask& task_;
  const ident::Control& control_;
  std::vector<double> x_;
  DelayResult out_;
};

}  // namespace

DelayResult run_delay(const DelayTask& task, const records::SeriesRecord& record, const ident::Control& control) {
  return DelayRun(task, control).run(record);
}

DelayResult run_delay(const DelayTask& task, const ident::Control& control) {
  return run_delay(task, read_channel(task), control);
}

}  // namespace jointid::tasks
