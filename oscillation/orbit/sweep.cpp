#include "oscillation/orbit/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
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

/// Watches the form and the contact from `after` on.
class Watch {
 public:
  Watch(StickSlip& motion, const SweepCase& each, SweepPoint& out) : each_(each), out_(out) {
    if (each.range_form.size() > 0) motion.on_piece = [this](const Piece& piece) { see(piece); };
    motion.on_event = [this](const Event& event) { see(event); };
  }

  void value(double time, double form) {
    out_.values.push_back(form);
    times_.push_back(time);
  }

  void finish() {
    if (each_.range_form.size() == 0 || !(seen_ > 0.0)) return;
    range_.stick_share = stuck_ / seen_;
    const std::vector<double>& values = out_.values;
    const double near = 1e-6 * (range_.largest - range_.smallest);
    for (std::size_t back = 1; back < values.size() && range_.slips == 0; ++back) {
      if (std::abs(values[values.size() - 1 - back] - values.back()) > near) continue;
      range_.slips = back;
      range_.period = times_.back() - times_[times_.size() - 1 - back];
    }
    out_.range = range_;
  }

 private:
  void see(const Event& event) {
    if (event.from != Mode::stick || event.time < each_.transient) return;
    ++range_.break_aways;
    if (each_.cycle == 0.0) value(event.time, each_.form.dot(event.state) + each_.offset);
  }

  /// Largest and smallest values at points of a piece: each is at most about a period of the fastest motion long.
  void see(const Piece& piece) {
    constexpr int points = 32;
    if (piece.start + piece.length <= each_.transient) return;
    if (seen_ == 0.0) range_.smallest = std::numeric_limits<double>::infinity(), range_.largest = -range_.smallest;
    const Eigen::VectorXd series = piece.along(each_.range_form);
    for (int i = 0; i <= points; ++i) {
      const double tau = piece.length * i / points;
      if (piece.start + tau < each_.transient) continue;
      double form = 0.0;
      for (Eigen::Index k = series.size() - 1; k >= 0; --k) form = form * tau + series[k];
      range_.smallest = std::min(range_.smallest, form + each_.range_offset);
      range_.largest = std::max(range_.largest, form + each_.range_offset);
    }
    const double length = piece.start + piece.length - std::max(piece.start, each_.transient);
    seen_ += length;
    if (piece.mode == Mode::stick) stuck_ += length;
  }

  const SweepCase& each_;
  SweepPoint& out_;
  SweptRange range_;
  std::vector<double> times_;
  double seen_ = 0.0, stuck_ = 0.0;
};

/// Once a cycle of the drive.
MotionEnd observe_cycles(StickSlip& motion, const SweepCase& each, Watch& watch) {
  if (!((each.transient + each.length) / each.cycle < static_cast<double>(motion.most_steps))) return MotionEnd::too_long;
  const auto cycles = [&](double time) { return static_cast<std::size_t>(time / each.cycle + 0.5); };
  const std::size_t first = cycles(each.transient), last = first + cycles(each.length);
  MotionEnd status = MotionEnd::ok;
  for (std::size_t k = 1; k <= last && status == MotionEnd::ok; ++k) {
    const double time = each.cycle * static_cast<double>(k);
    status = motion.advance(time);
    if (k > first) watch.value(time, each.form.dot(motion.state()) + each.offset);
  }
  return status;
}

MotionEnd observe_break_aways(StickSlip& motion, const SweepCase& each) {
  const MotionEnd status = motion.advance(each.transient);
  return status == MotionEnd::ok ? motion.advance(each.transient + each.length) : status;
}

/// The end of a motion, where the next one begins.
struct End {
  Eigen::VectorXd state;
  Mode mode = Mode::forward;
};

SweepPoint observe(double parameter, const SweepCase& each, const SweepOptions& options, End* end = nullptr) {
  check(each);
  SweepPoint out{parameter, MotionEnd::ok, {}};
  const bool keeps_mode = end != nullptr && end->state.size() > 0;
  StickSlip motion(each.system, each.start, keeps_mode ? std::optional(end->mode) : std::nullopt);
  motion.interrupted = options.interrupted;
  motion.most_steps = most_steps_of_points;
  Watch watch(motion, each, out);
  out.status = each.cycle > 0.0 ? observe_cycles(motion, each, watch) : observe_break_aways(motion, each);
  watch.finish();
  if (end != nullptr) *end = {motion.state(), motion.mode()};
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

std::vector<SweepPoint> continued_sweep(const std::vector<double>& parameters, const std::function<SweepCase(double)>& make,
                                        const SweepOptions& options) {
  std::vector<SweepPoint> out;
  End end;
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    SweepCase each = make(parameters[k]);
    const Eigen::Index n = each.system.degrees();
    End next;
    if (k > 0) {
      each.start = each.system.state(end.state.head(n), end.state.segment(n, n));
      const Eigen::Index last = each.start.size() - 1;
      each.start(last) = end.state(last);  // the elongation of a contact spring
      if (end.state(last) != 0.0) next = end;
    }
    out.push_back(observe(parameters[k], each, options, &next));
    const bool up = parameters.back() > parameters.front();
    out.back().direction = up ? 1 : -1;
    if (options.done) options.done(out.back());
    if (out.back().status != MotionEnd::ok) break;
    end = std::move(next);
  }
  return out;
}

}  // namespace jointid::oscillation
