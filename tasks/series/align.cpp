#include "tasks/series/align.hpp"

#include <algorithm>
#include <cmath>

#include "base/control.hpp"
#include "frf/file/columns.hpp"
#include "oscillation/measurement/phase.hpp"
#include "tasks/tell.hpp"

namespace jointid::tasks {
namespace {

/// The place of a channel by name, whatever its case, or number from 1.
std::size_t place_of(const records::SeriesRecord& record, const std::string& wanted) {
  frf::Columns titles{record.file, {}};
  for (const auto& [name, unit] : record.channels) titles.columns.push_back({name, unit, {}});
  return static_cast<std::size_t>(&titles.column(wanted) - titles.columns.data());
}

/// Root mean square without the mean, of the samples that are there.
double rms_of(const std::vector<double>& samples) {
  double sum = 0.0, squares = 0.0, count = 0.0;
  for (const double x : samples) {
    if (!std::isfinite(x)) continue;
    sum += x, squares += x * x, ++count;
  }
  return count > 0.0 ? std::sqrt(std::max(0.0, squares / count - sum / count * (sum / count))) : 0.0;
}

}  // namespace

AlignResult run_align(const AlignTask& task, records::SeriesRecord record, const ident::Control& control) {
  AlignResult out{task, std::move(record), {}};
  const std::size_t reference = place_of(out.record, task.reference);
  std::vector<oscillation::Harmonics> fitted;
  for (const std::vector<double>& x : out.record.samples) {
    tell(control, "harmonics", fitted.size(), out.record.samples.size());
    stop_if(control.interrupted);
    fitted.push_back(oscillation::fit_harmonics(x, 1.0 / out.record.rate_hz, task.frequency_hz, task.harmonics));
  }
  for (std::size_t k = 0; k < fitted.size(); ++k) {
    const double rms = rms_of(out.record.samples[k]);
    out.channels.push_back({out.record.channels[k].name, fitted[k].amplitude.front(),
                            oscillation::delay_between(fitted[reference], fitted[k], task.frequency_hz),
                            rms > 0.0 ? fitted[k].rest / rms : 0.0});
  }
  return out;
}

AlignResult run_align(const AlignTask& task, const ident::Control& control) {
  tell(control, "reading samples");
  return run_align(task, records::read_series(task.file, {{}, task.rate_hz, 0}), control);
}

std::vector<double> aligned(const AlignResult& found, std::size_t channel) {
  const double delay = found.channels[channel].delay;
  const std::vector<double>& measured = found.record.samples[channel];
  return delay == 0.0 ? measured : oscillation::advanced(measured, 1.0 / found.record.rate_hz, delay);
}

}  // namespace jointid::tasks
