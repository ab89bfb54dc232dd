#include "tasks/series/reversal.hpp"

#include <cmath>

#include "base/control.hpp"
#include "base/error.hpp"
#include "tasks/tell.hpp"

namespace jointid::tasks {

ReversalResult run_reversal(const ReversalTask& task, const records::SeriesRecord& record) {
  if (record.samples.size() != 2)
    throw InputError({ErrorKind::usage, record.file, "", "has " + std::to_string(record.samples.size()) + " channels",
                      "give displacement and force"});
  ReversalResult out{record.file, {}, {}, 0, {}};
  for (std::size_t i = 0; i < record.samples[0].size(); ++i) {
    const double displacement = record.samples[0][i], force = record.samples[1][i];
    if (!std::isfinite(displacement) || !std::isfinite(force)) {
      ++out.missing;
      continue;
    }
    out.displacement.push_back(displacement);
    out.force.push_back(force);
  }
  out.found = oscillation::reversal_stiffness({out.displacement, out.force}, task.options);
  return out;
}

ReversalResult run_reversal(const ReversalTask& task, const ident::Control& control) {
  tell(control, "reading samples");
  records::SeriesOptions options{{task.displacement, task.force}, task.rate_hz, 0};
  options.without_times = true;
  const records::SeriesRecord record = records::read_series(task.file, options);
  stop_if(control.interrupted);
  tell(control, "slopes");
  return run_reversal(task, record);
}

}  // namespace jointid::tasks
