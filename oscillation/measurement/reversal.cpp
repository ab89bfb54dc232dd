#include "oscillation/measurement/reversal.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/error.hpp"
#include "base/statistics.hpp"

namespace jointid::oscillation {
namespace {

[[noreturn]] void wrong_reversals(const std::string& problem, const std::string& remedy) {
  throw InputError({ErrorKind::data, "", "record", problem, remedy});
}

double median_slip_force(std::span<const double> force) {
  double largest = 0.0;
  for (const double each : force) largest = std::max(largest, std::abs(each));
  std::vector<double> slipping;
  for (const double each : force) {
    if (std::abs(each) > 0.5 * largest) slipping.push_back(std::abs(each));
  }
  return slipping.empty() ? 0.0 : median(std::move(slipping));
}

/// Samples [first, last) between the limits.
struct Part {
  std::size_t first, last;
};

/// Runs of samples within the limit that enter at one of its ends and leave at the other.
std::vector<Part> straight_parts(std::span<const double> force, double limit) {
  std::vector<Part> parts;
  std::size_t first = force.size();
  for (std::size_t i = 1; i < force.size(); ++i) {
    const bool inside = std::abs(force[i]) <= limit, was_inside = std::abs(force[i - 1]) <= limit;
    if (inside && !was_inside) first = i;
    if (inside || !was_inside || first >= i) continue;
    if ((force[first - 1] > 0.0) != (force[i] > 0.0)) parts.push_back({first, i});
    first = force.size();
  }
  return parts;
}

/// Slope of the force over the displacement by least squares.
double fitted_slope(const ReversalRecord& record, const Part& part) {
  const double n = static_cast<double>(part.last - part.first);
  double mean_d = 0.0, mean_f = 0.0, dd = 0.0, df = 0.0;
  for (std::size_t i = part.first; i < part.last; ++i) mean_d += record.displacement[i] / n, mean_f += record.force[i] / n;
  for (std::size_t i = part.first; i < part.last; ++i) {
    const double d = record.displacement[i] - mean_d;
    dd += d * d;
    df += d * (record.force[i] - mean_f);
  }
  return df / dd;
}

ReversalSlopes slopes_of(const std::vector<double>& slopes) {
  ReversalSlopes out{slopes.size(), 0.0, nan};
  const double n = static_cast<double>(slopes.size());
  for (const double each : slopes) out.slope += each / n;
  if (slopes.size() < 2) return out;
  double squares = 0.0;
  for (const double each : slopes) squares += (each - out.slope) * (each - out.slope);
  out.error = std::sqrt(squares / (n - 1.0) / n);
  return out;
}

void check(const ReversalRecord& record, const ReversalOptions& options) {
  if (record.displacement.size() != record.force.size()) wrong_reversals("has channels of different length", "cut them alike");
  if (!(options.share > 0.0 && options.share < 1.0))
    throw InputError({ErrorKind::usage, "", "share", "is not between 0 and 1", "0.8 is usual"});
}

/// Both directions together, and the series of springs undone.
void finish(ReversalStiffness& out, const ReversalOptions& options) {
  const ReversalSlopes &ahead = out.forward, &back = out.backward;
  if (ahead.parts == 0 || back.parts == 0) {
    out.remark = "only one direction has straight parts: a tilt of the contact is not known apart from its stiffness";
    out.slope = ahead.parts > 0 ? ahead.slope : back.slope;
    out.slope_error = ahead.parts > 0 ? ahead.error : back.error;
  } else {
    out.slope = 0.5 * (ahead.slope + back.slope);
    out.slope_error = 0.5 * std::hypot(ahead.error, back.error);
  }
  out.stiffness = out.slope;
  if (options.body_stiffness) {
    if (!(out.slope < *options.body_stiffness)) {
      wrong_reversals("has a slope of " + std::to_string(out.slope) + " N/m, which is not below the body's " +
                          std::to_string(*options.body_stiffness) + " N/m",
                      "two springs in series are softer than either: leave the body's stiffness out where the displacement is that "
                      "of the slider against the nub");
    }
    out.stiffness = out.slope * *options.body_stiffness / (*options.body_stiffness - out.slope);
  }
  out.stuck_travel = 2.0 * out.slip_force / out.stiffness;
}

}  // namespace

ReversalStiffness reversal_stiffness(const ReversalRecord& record, const ReversalOptions& options) {
  check(record, options);
  ReversalStiffness out;
  out.slip_force = options.slip_force.value_or(median_slip_force(record.force));
  if (!(out.slip_force > 0.0)) wrong_reversals("has no force", "choose another column for the force");
  std::vector<double> forward, backward;
  for (const Part& part : straight_parts(record.force, options.share * out.slip_force)) {
    const double travel = record.displacement[part.last - 1] - record.displacement[part.first];
    if (part.last - part.first < 3 || travel == 0.0) {
      ++out.skipped;
      continue;
    }
    (travel > 0.0 ? forward : backward).push_back(fitted_slope(record, part));
  }
  if (forward.empty() && backward.empty()) {
    wrong_reversals("has no straight part of 3 samples or more between the limits of slip",
                    "sample faster, or give the slip force and a larger share");
  }
  out.forward = slopes_of(forward);
  out.backward = slopes_of(backward);
  finish(out, options);
  if (!(out.slope > 0.0)) {
    wrong_reversals("has a force that falls with the displacement after reversals",
                    "turn the sign of one channel: the force is that on the body");
  }
  return out;
}

}  // namespace jointid::oscillation
