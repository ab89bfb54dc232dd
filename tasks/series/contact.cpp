#include "tasks/series/contact.hpp"

#include <algorithm>
#include <cmath>

#include "base/control.hpp"
#include "base/error.hpp"
#include "oscillation/measurement/phase.hpp"
#include "tasks/tell.hpp"

namespace jointid::tasks {
namespace {

records::SeriesRecord read_contact(const ContactTask& task) {
  if (task.normal.empty() == (task.load == 0.0))
    throw InputError({ErrorKind::usage, "", "--normal", "or give the normal load by --load: one of the two",
                      "give a column, or a constant load in N"});
  records::SeriesOptions options{{task.velocity, task.force}, task.rate_hz, 0};
  if (!task.normal.empty()) options.channels.push_back(task.normal);
  options.without_times = task.force_delay == 0.0;
  return records::read_series(task.file, options);
}

}  // namespace

ContactResult run_contact(const ContactTask& task, records::SeriesRecord record) {
  const std::size_t wanted = task.load > 0.0 ? 2 : 3;
  if (record.samples.size() != wanted)
    throw InputError({ErrorKind::usage, record.file, "", "has " + std::to_string(record.samples.size()) + " channels",
                      "give velocity, force and, where there is no constant load, the normal load"});
  if (task.force_delay != 0.0) record.samples[1] = oscillation::advanced(record.samples[1], 1.0 / record.rate_hz, task.force_delay);
  ContactResult out{record.file, {}, {}, {}, 0, {}};
  for (std::size_t i = 0; i < record.samples[0].size(); ++i) {
    const bool there = std::ranges::all_of(record.samples, [i](const auto& channel) { return std::isfinite(channel[i]); });
    out.missing += there ? 0 : 1;
    if (!there) continue;
    out.velocity.push_back(record.samples[0][i]);
    out.force.push_back(record.samples[1][i]);
    out.normal.push_back(task.load > 0.0 ? task.load : record.samples[2][i]);
  }
  out.law = oscillation::friction_law({out.velocity, out.force, out.normal}, {task.stick_speed, 0.0});
  return out;
}

ContactResult run_contact(const ContactTask& task, const ident::Control& control) {
  tell(control, "reading samples");
  records::SeriesRecord record = read_contact(task);
  stop_if(control.interrupted);
  tell(control, "law");
  return run_contact(task, std::move(record));
}

}  // namespace jointid::tasks
