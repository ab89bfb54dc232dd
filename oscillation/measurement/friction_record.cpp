#include "oscillation/measurement/friction_record.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/error.hpp"
#include "base/statistics.hpp"
#include "dense/cholesky.hpp"
#include "minimise/least_value.hpp"

namespace jointid::oscillation {
namespace {

InputError wrong_record(const std::string& place, const std::string& problem, const std::string& remedy) {
  return InputError({ErrorKind::data, "", place, problem, remedy});
}

/// Slipping samples: speed and μ.
struct Slip {
  std::vector<double> speed, mu;
};

/// μ_K and μ_S − μ_K of a given α by linear least squares.
struct Line {
  double kinetic = 0.0, drop = 0.0, squares = 0.0;
};

Line line(const Slip& slip, double decay) {
  const double n = static_cast<double>(slip.mu.size());
  double me = 0.0, mm = 0.0, see = 0.0, sem = 0.0;
  for (std::size_t i = 0; i < slip.mu.size(); ++i) me += std::exp(-decay * slip.speed[i]) / n, mm += slip.mu[i] / n;
  for (std::size_t i = 0; i < slip.mu.size(); ++i) {
    const double e = std::exp(-decay * slip.speed[i]) - me;
    see += e * e;
    sem += e * (slip.mu[i] - mm);
  }
  Line out;
  out.drop = see > 0.0 ? sem / see : 0.0;
  out.kinetic = mm - out.drop * me;
  for (std::size_t i = 0; i < slip.mu.size(); ++i) {
    const double rest = slip.mu[i] - out.kinetic - out.drop * std::exp(-decay * slip.speed[i]);
    out.squares += rest * rest;
  }
  return out;
}

/// The α of the smallest sum of squares: a logarithmic grid, then golden sections.
double best_decay(const Slip& slip, double most) {
  const auto decay = [&](double share) { return most * std::pow(1e-4, 1.0 - share); };
  return decay(least_over([&](double share) { return line(slip, decay(share)).squares; }, 0.0, 1.0, 120, 1e-14));
}

void add_errors(FrictionLaw& law, const Slip& slip) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  for (const double v : slip.speed) {
    const double e = std::exp(-law.decay * v);
    const Eigen::Vector3d row(1.0, e, -law.drop * v * e);
    normal += row * row.transpose();
  }
  const Eigen::Vector3d scale = normal.diagonal().cwiseSqrt().cwiseInverse();
  const auto solved = dense::solve_definite(scale.asDiagonal() * normal * scale.asDiagonal(), Eigen::Vector3d::Zero());
  if (!solved || solved->reciprocal_condition < 1e-14) return;
  const Eigen::MatrixXd inverse =
      dense::solve_positive(Eigen::MatrixXd(scale.asDiagonal() * normal * scale.asDiagonal()), Eigen::MatrixXd::Identity(3, 3));
  const Eigen::Vector3d error = law.scatter * inverse.diagonal().cwiseSqrt().cwiseProduct(scale);
  law.kinetic_error = error(0), law.drop_error = error(1), law.decay_error = error(2);
}

void fit(FrictionLaw& law, const Slip& slip, const FrictionRecordOptions& options) {
  const double n = static_cast<double>(slip.mu.size());
  const Line constant = line(slip, 0.0);
  law.kinetic = constant.kinetic + constant.drop;
  law.scatter = std::sqrt(constant.squares / std::max(n - 1.0, 1.0));
  law.kinetic_error = law.scatter / std::sqrt(n);
  const auto [slowest, fastest] = std::ranges::minmax(slip.speed);
  if (slip.mu.size() < 6 || fastest < 1.5 * slowest) {
    law.remark = "the slipping speeds are too few or too alike to show a falling law";
    return;
  }
  const double most = options.most_decay > 0.0 ? options.most_decay : 30.0 / median(slip.speed);
  const double decay = best_decay(slip, most);
  const Line falling = line(slip, decay);
  const double floor = 1e-300;
  const bool better =
      n * std::log(std::max(constant.squares, floor)) + 2.0 > n * std::log(std::max(falling.squares, floor)) + 6.0;
  if (!better || falling.drop <= 0.0) return;
  law.falls = true;
  law.kinetic = falling.kinetic, law.drop = falling.drop, law.decay = decay;
  law.scatter = std::sqrt(falling.squares / (n - 3.0));
  add_errors(law, slip);
  if (decay > 0.98 * most || decay < 1.5e-4 * most)
    law.remark = "the decay lies at an end of its range: the speeds of the record do not fix it";
}

}  // namespace

FrictionLaw friction_law(const FrictionRecord& record, const FrictionRecordOptions& options) {
  const std::size_t n = record.velocity.size();
  if (record.force.size() != n || (!record.normal.empty() && record.normal.size() != n)) {
    throw wrong_record("record", "has channels of different lengths", "resample them to the same instants");
  }
  if (!(options.stick_speed > 0.0))
    throw wrong_record("stick_speed", "is not above 0", "take a few times the noise of the velocity");
  FrictionLaw law;
  Slip slip;
  for (std::size_t i = 0; i < n; ++i) {
    const double load = record.normal.empty() ? 1.0 : record.normal[i];
    if (!(load > 0.0) || !std::isfinite(record.velocity[i]) || !std::isfinite(record.force[i])) {
      throw wrong_record("sample " + std::to_string(i), "has no force, velocity or positive normal load",
                         "cut the record to closed contact");
    }
    if (std::abs(record.velocity[i]) <= options.stick_speed) {
      law.stick_samples += 1;
      law.static_bound = std::max(law.static_bound.value_or(0.0), std::abs(record.force[i]) / load);
    } else {
      slip.speed.push_back(std::abs(record.velocity[i]));
      slip.mu.push_back(std::copysign(1.0, record.velocity[i]) * record.force[i] / load);
    }
  }
  law.slip_samples = slip.mu.size();
  if (slip.mu.empty())
    throw wrong_record("record", "has no sample above the stick speed", "a stick bounds μ_S only: record slips too");
  fit(law, slip, options);
  return law;
}

double contact_force(const Eigen::VectorXd& direction, const Eigen::MatrixXd& mass, const Eigen::MatrixXd& damping,
                     const Eigen::MatrixXd& stiffness, const Eigen::VectorXd& x, const Eigen::VectorXd& v,
                     const Eigen::VectorXd& a) {
  return direction.dot(mass * a + damping * v + stiffness * x);
}

SawtoothFriction sawtooth_friction(double largest, double smallest, double normal) {
  if (!(normal > 0.0) || !(largest >= smallest))
    throw wrong_record("sawtooth", "needs a positive normal load and its extremes in order", "");
  return {0.5 * (largest + smallest) / normal, largest / normal};
}

}  // namespace jointid::oscillation
