#include "oscillation/orbit/sweep.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

#include "base/error.hpp"

namespace jointid::oscillation {
namespace {

SweepPoint observe(double parameter, const SweepCase& each, const SweepOptions& options) {
  SweepPoint out{parameter, Status::ok, {}};
  StickSlip motion(each.system, each.start);
  if (options.cycle > 0.0) {
    const auto cycles = [&](double time) { return static_cast<std::size_t>(time / options.cycle + 0.5); };
    const std::size_t first = cycles(options.transient), count = cycles(options.length);
    for (std::size_t k = 0; k < first + count && out.status == Status::ok; ++k) {
      out.status = motion.advance(options.cycle * static_cast<double>(k + 1));
      if (k >= first) out.values.push_back(each.form.dot(motion.state()));
    }
    return out;
  }
  out.status = motion.advance(options.transient);
  motion.on_event = [&](const Event& event) {
    if (event.from == Mode::stick) out.values.push_back(each.form.dot(event.state));
  };
  if (out.status == Status::ok) out.status = motion.advance(options.transient + options.length);
  return out;
}

}  // namespace

std::vector<SweepPoint> sweep(const std::vector<double>& parameters, const std::function<SweepCase(double)>& make,
                              const SweepOptions& options) {
  if (!(options.length > 0.0) || options.transient < 0.0 || options.cycle < 0.0) {
    throw InputError({ErrorKind::usage, "", "length, transient, cycle", "are not usable times", ""});
  }
  const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
  const std::size_t threads =
      std::min(options.threads > 0 ? options.threads : cores, std::max<std::size_t>(parameters.size(), 1));
  std::vector<SweepPoint> out(parameters.size());
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex mutex;
  const auto work = [&] {
    try {
      for (std::size_t k = next++; k < parameters.size(); k = next++)
        out[k] = observe(parameters[k], make(parameters[k]), options);
    } catch (...) {
      const std::lock_guard lock(mutex);
      failure = std::current_exception();
      next = parameters.size();
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t t = 1; t < threads; ++t) others.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
  return out;
}

}  // namespace jointid::oscillation
