#include "oscillation/orbit/sweep.hpp"

#include <algorithm>
#include <mutex>

#include "base/error.hpp"
#include "base/parallel.hpp"

namespace jointid::oscillation {
namespace {

constexpr std::size_t most_steps_of_points = 300'000;

void check(const SweepCase& each) {
  if (each.length > 0.0 && each.transient >= 0.0 && each.cycle >= 0.0) return;
  throw InputError({ErrorKind::usage, "", "length, transient, cycle", "are not usable times", ""});
}

/// Once a cycle of the drive.
MotionEnd observe_cycles(StickSlip& motion, const SweepCase& each, std::vector<double>& values) {
  if (!((each.transient + each.length) / each.cycle < static_cast<double>(motion.most_steps))) return MotionEnd::too_long;
  const auto cycles = [&](double time) { return static_cast<std::size_t>(time / each.cycle + 0.5); };
  const std::size_t first = cycles(each.transient), last = first + cycles(each.length);
  MotionEnd status = MotionEnd::ok;
  for (std::size_t k = 1; k <= last && status == MotionEnd::ok; ++k) {
    status = motion.advance(each.cycle * static_cast<double>(k));
    if (k > first) values.push_back(each.form.dot(motion.state()));
  }
  return status;
}

MotionEnd observe_break_aways(StickSlip& motion, const SweepCase& each, std::vector<double>& values) {
  const MotionEnd status = motion.advance(each.transient);
  motion.on_event = [&](const Event& event) {
    if (event.from == Mode::stick) values.push_back(each.form.dot(event.state));
  };
  return status == MotionEnd::ok ? motion.advance(each.transient + each.length) : status;
}

SweepPoint observe(double parameter, const SweepCase& each, const SweepOptions& options) {
  check(each);
  SweepPoint out{parameter, MotionEnd::ok, {}};
  StickSlip motion(each.system, each.start);
  motion.interrupted = options.interrupted;
  motion.most_steps = most_steps_of_points;
  out.status = each.cycle > 0.0 ? observe_cycles(motion, each, out.values) : observe_break_aways(motion, each, out.values);
  return out;
}

}  // namespace

std::vector<SweepPoint> sweep(const std::vector<double>& parameters, const std::function<SweepCase(double)>& make,
                              const SweepOptions& options) {
  std::vector<SweepPoint> out(parameters.size());
  std::mutex mutex;
  for_each_index(parameters.size(), threads_or_cores(options.threads), [&](std::size_t k) {
    out[k] = observe(parameters[k], make(parameters[k]), options);
    const std::scoped_lock lock(mutex);
    if (options.done) options.done(out[k]);
  });
  return out;
}

}  // namespace jointid::oscillation
