#include "response/orbit/periodic_orbit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dense/eigen.hpp"
#include "dense/minimum_norm.hpp"
#include "response/orbit/period_map.hpp"

namespace jointid::response {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// (I − Φ) ds = image − s, and no residual force where a joint sticks; of smallest norm should another multiplier be 1.
VectorXd newton_step(const PeriodMap& map) {
  const VectorXd scales = map.scales();
  MatrixXd jacobian = MatrixXd::Identity(scales.size(), scales.size()) - map.derivative();
  VectorXd right = map.image() - map.state().head(map.image().size());
  const std::vector<bool> idle = map.idle_rows();
  for (Index row = 0; row < right.size(); ++row) {
    if (!idle[static_cast<std::size_t>(row)]) continue;
    jacobian.row(row) = map.residual_derivative(row);
    right[row] = -map.residual_force(row);
  }
  jacobian = scales.cwiseInverse().asDiagonal() * jacobian * scales.asDiagonal();
  const VectorXd step = dense::RealMinimumNorm(jacobian, 1e-12).solve(right.cwiseQuotient(scales));
  return scales.cwiseProduct(step);
}

/// What the equations of newton_step() lack.
double lack(const PeriodMap& map) {
  double lack = map.closure();
  const VectorXd scales = map.scales();
  const std::vector<bool> idle = map.idle_rows();
  for (Index row = 0; row < scales.size(); ++row) {
    if (idle[static_cast<std::size_t>(row)]) lack = std::max(lack, std::abs(map.residual_force(row)) / scales[row]);
  }
  return lack;
}

/// Of every element of the image, what it is where its energy is 1/2: eigenvalues keep their digits in such units.
VectorXd energy_sizes(const JointedStructure& structure, const PeriodMap& map) {
  const Index n = structure.coordinates();
  const VectorXd joints = structure.initial_stiffness();
  const MatrixXd stiffness =
      structure.matrices.stiffness + structure.incidence * joints.asDiagonal() * structure.incidence.transpose();
  VectorXd sizes = VectorXd::Ones(map.image().size());
  const double softest = 1e-12 * stiffness.diagonal().maxCoeff();
  for (Index i = 0; i < n; ++i) {
    sizes[i] = softest > 0.0 ? 1.0 / std::sqrt(std::max(stiffness(i, i), softest)) : 1.0;
    sizes[n + i] = 1.0 / std::sqrt(structure.matrices.mass(i, i));
  }
  Index row = 2 * n;
  for (Index j = 0; j < structure.joints(); ++j) {
    if (map.bilinear(j)) sizes[row++] = std::sqrt(joints[j]);
  }
  if (row < sizes.size() && joints.maxCoeff() > 0.0)
    sizes.tail(sizes.size() - row).setConstant(1.0 / std::sqrt(joints.maxCoeff()));
  return sizes;
}

void describe(PeriodMap& map, PeriodicOrbit& orbit) {
  const Index n = map.march().structure().coordinates(), joints = map.march().structure().joints();
  orbit.closure = map.closure();
  orbit.events = map.events();
  bool remembered = false;
  for (Index j = 0; j < joints; ++j) remembered = remembered || (map.residual_force_free(j) && !map.bilinear(j));
  if (remembered) {
    map.keep_residual_forces();
    map.run(true);
  }
  const VectorXd sizes = energy_sizes(map.march().structure(), map);
  const Eigen::VectorXcd eigenvalues =
      dense::eigenvalues(sizes.cwiseInverse().asDiagonal() * map.derivative() * sizes.asDiagonal());
  std::vector<Complex> multipliers(eigenvalues.begin(), eigenvalues.end());
  for (Index j = 0; j < joints; ++j) {
    orbit.residual_force_free.push_back(map.residual_force_free(j));
    if (map.residual_force_free(j) && !map.bilinear(j)) multipliers.emplace_back(1.0);  // the largest corner, were it larger
  }
  orbit.multipliers = Eigen::Map<const Eigen::VectorXcd>(multipliers.data(), at(multipliers.size()));
  std::sort(orbit.multipliers.begin(), orbit.multipliers.end(), [](Complex a, Complex b) { return std::abs(a) > std::abs(b); });
  orbit.stable = orbit.multipliers.size() == 0 || std::abs(orbit.multipliers[0]) <= 1.0 + 1e-8;
  map.place();
  const Instant start = map.march().motion();
  orbit.x = start.x.head(n);
  orbit.v = start.v;
  orbit.f = start.f;
  for (const auto& joint : map.march().joint_states()) orbit.joints.push_back(joint->clone());
}

/// `to_march` periods from the map's state, then Newton's steps while they halve what is lacking within four; else the motion
/// settles by itself for a while, ever longer; so it does where a step led to a state from which no march goes on, or where only
/// derivatives by the state do not follow it.
PeriodicOrbit find_from(PeriodMap& map, int to_march, const OrbitOptions& options) {
  PeriodicOrbit orbit;
  int patience = 4, rest = 4;
  bool moved = false;
  double best = std::numeric_limits<double>::infinity(), last = best;
  const auto settle = [&] {
    to_march = rest;
    rest *= 2;
    patience = 4;
    best = std::numeric_limits<double>::infinity();
    moved = false;
  };
  while (true) {
    ++orbit.periods;
    if (!map.run(to_march == 0)) {
      const bool by_itself = !moved && to_march > 0;
      if (by_itself || orbit.periods >= options.most_periods) return orbit;
      if (moved) map.abandon_move();
      settle();
      continue;
    }
    const double now = lack(map);
    if (to_march > 0 && now > options.closure) {
      --to_march;
      map.accept_image();
      continue;
    }
    if (to_march > 0) {  // it is there already; once more for the multipliers
      to_march = 0;
      continue;
    }
    if (now <= options.closure || (now <= 1e4 * options.closure && now > 0.1 * last)) {
      orbit.closed = true;
      break;
    }
    if (orbit.periods >= options.most_periods) break;
    last = now;
    if (now <= 0.5 * best) {
      best = now;
      patience = 4;
    } else if (--patience == 0) {
      settle();
      map.accept_image();
      continue;
    }
    map.move(newton_step(map));
    moved = true;
    ++orbit.newton_steps;
  }
  describe(map, orbit);
  return orbit;
}

}  // namespace

PeriodicOrbit find_orbit(const PeriodicProblem& problem, const OrbitOptions& options) {
  PeriodMap map(problem, options.march);
  return find_from(map, options.first_periods, options);
}

PeriodicOrbit find_orbit(const PeriodicProblem& problem, const OrbitStart& start, const OrbitOptions& options) {
  PeriodMap map(problem, options.march);
  map.start(start.x, start.v, start.f, start.turns);
  return find_from(map, 0, options);
}

}  // namespace jointid::response
