#include "friction/path/record.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace jointid::friction {
namespace {

/// u_s(F) of a specimen for F ≥ 0.
double deformation(const Record& specimen, double force) {
  const auto above = std::ranges::lower_bound(specimen.force, force);
  const auto end = static_cast<std::size_t>(std::min(above, specimen.force.end() - 1) - specimen.force.begin());
  const double u1 = specimen.displacement[end], f1 = specimen.force[end];
  const double u0 = end == 0 ? 0.0 : specimen.displacement[end - 1], f0 = end == 0 ? 0.0 : specimen.force[end - 1];
  return u0 + (force - f0) * (u1 - u0) / (f1 - f0);
}

/// In the first quadrant, without the origin.
Record positive(const Record& specimen) {
  Record out;
  for (std::size_t i = 0; i < specimen.force.size(); ++i) {
    if (specimen.force[i] == 0.0) continue;
    out.force.push_back(std::abs(specimen.force[i]));
    out.displacement.push_back(std::copysign(1.0, specimen.force[i]) * specimen.displacement[i]);
  }
  return out;
}

}  // namespace

std::vector<double> integrated(std::span<const double> time, std::span<const double> velocity) {
  if (time.size() != velocity.size()) refuse("time and velocity are not equally long");
  std::vector<double> out(time.size(), 0.0);
  for (std::size_t i = 1; i < time.size(); ++i) {
    if (!(time[i] > time[i - 1])) refuse("time does not increase at sample " + std::to_string(i + 1));
    out[i] = out[i - 1] + 0.5 * (time[i] - time[i - 1]) * (velocity[i] + velocity[i - 1]);
  }
  return out;
}

Record without_elastic(Record record, double stiffness) {
  if (!(stiffness > 0.0)) refuse("the stiffness of the specimen is not positive");
  for (std::size_t i = 0; i < record.force.size(); ++i) record.displacement[i] -= record.force[i] / stiffness;
  return record;
}

Record without_elastic(Record record, const Record& specimen) {
  const Record curve = positive(specimen);
  if (curve.force.empty() || std::ranges::adjacent_find(curve.force, std::greater_equal<>()) != curve.force.end()) {
    refuse("the specimen's forces do not increase");
  }
  for (std::size_t i = 0; i < record.force.size(); ++i) {
    record.displacement[i] -= std::copysign(1.0, record.force[i]) * deformation(curve, std::abs(record.force[i]));
  }
  return record;
}

double work(const Record& record) {
  double sum = 0.0;
  for (std::size_t i = 1; i < record.force.size(); ++i) {
    sum += 0.5 * (record.force[i] + record.force[i - 1]) * (record.displacement[i] - record.displacement[i - 1]);
  }
  return sum;
}

Record with_force_times(Record record, double factor) {
  for (double& force : record.force) force *= factor;
  return record;
}

Record finite_samples(const Record& record) {
  Record out;
  for (std::size_t i = 0; i < record.force.size(); ++i) {
    if (!std::isfinite(record.force[i]) || !std::isfinite(record.displacement[i])) continue;
    out.displacement.push_back(record.displacement[i]);
    out.force.push_back(record.force[i]);
  }
  return out;
}

}  // namespace jointid::friction
