// Time marching of the thesis's 18-DOF structure with joints of types A to E (docs/time-marching.md): error against run time of
// Algorithm One, Algorithm Two and event-exact marching, from rest over five periods of p = sin 100πt, and the steady state by
// Newton's method. Promised: event-exact marching agrees with itself in steps a third as long to 1e-9; Algorithm One on type D at
// 5e-5 s within 5 %, its errors fall with the step at an order of 1.2 at least; orbits close, keep their energy to 1e-12 (type A:
// 1e-11) and have the largest |x₅| of the table. The quick run leaves the shortest step out.
#include <fmt/core.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "bench/bench.hpp"
#include "dense/eigen.hpp"
#include "friction/law/laws.hpp"
#include "problems/structure/beam.hpp"
#include "response/orbit/orbit_figures.hpp"
#include "response/time/algorithm_one.hpp"
#include "response/time/algorithm_two.hpp"

namespace {

using namespace jointid;
using namespace jointid::response;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double omega = 100.0 * std::numbers::pi, until = 0.1;
constexpr Index force_at = 4;  // coordinate 5

struct JointType {
  std::string name, law;
  std::vector<double> values;
  double largest;  ///< max |x₅| of the steady state, m (response.md §11)
};

const std::vector<JointType> types = {{"A", "spring", {1e6}, 2.472486e-6},
                                      {"B", "bilinear", {4e-7, 1e6}, 1.859820e-6},
                                      {"C", "bilinear", {4e-9, 1e8}, 1.150651e-6},
                                      {"D", "bilinear", {4e-11, 1e10}, 1.159558e-6},
                                      {"E", "ren", {6.36e-8, 3.0, 1e6}, 1.80356e-6}};

MatrixXd dense_matrix(const problems::Matrix& rows) {
  MatrixXd out(rows.size(), rows.size());
  for (Index i = 0; i < out.rows(); ++i)
    out.row(i) = Eigen::Map<const Eigen::RowVectorXd>(rows[static_cast<std::size_t>(i)].data(), out.cols());
  return out;
}

/// Two cantilevers of 5 and 4 elements, 1 % of critical damping in every mode (R3.66), joints from 5 to 13 and from 7 to the
/// ground.
JointedStructure structure_of(const JointType& type) {
  const problems::BeamSection section{.width = 0.05, .thickness = 0.012, .youngs_modulus = 2.07e11, .density = 7547.0};
  MatrixXd mass = MatrixXd::Zero(18, 18), stiffness = mass;
  const auto add = [&](Index first, int elements) {
    for (int e = 0; e < elements; ++e) {
      const MatrixXd m = dense_matrix(problems::element_mass(section, 0.1325)),
                     k = dense_matrix(problems::element_stiffness(section, 0.1325));
      const Index at = first + 2 * (e - 1), skip = e == 0 ? 2 : 0, size = 4 - skip;  // the first element's left end is clamped
      mass.block(at + skip, at + skip, size, size) += m.bottomRightCorner(size, size);
      stiffness.block(at + skip, at + skip, size, size) += k.bottomRightCorner(size, size);
    }
  };
  add(0, 5);
  add(10, 4);
  const dense::SymmetricEigen modes = dense::symmetric_eigen(stiffness, mass);
  const MatrixXd shapes = mass * modes.vectors;
  JointedStructure out;
  out.matrices = {mass, 0.02 * shapes * modes.values.cwiseSqrt().asDiagonal() * shapes.transpose(), stiffness};
  out.incidence = MatrixXd::Zero(18, 2);
  out.incidence(4, 0) = out.incidence(6, 1) = 1.0;
  out.incidence(12, 0) = -1.0;
  for (int j = 0; j < 2; ++j) out.laws.push_back(friction::make_element(type.law, type.values));
  return out;
}

ForceHistory sine() { return ForceHistory::periodic(omega, {1}, Complex(0.0, -1.0) * VectorXd::Unit(18, force_at)); }

/// x₅ every millisecond.
VectorXd exact_motion(const JointedStructure& structure, const MarchOptions& options) {
  ExactMarch march(structure, sine(), options);
  VectorXd x(100);
  for (Index i = 0; i < x.size(); ++i) {
    march.march(until * static_cast<double>(i + 1) / 100.0);
    x[i] = march.motion().x[force_at];
  }
  return x;
}

template <class Algorithm>
VectorXd steps_of(Algorithm& algorithm, double delta) {
  VectorXd x(100);
  const auto every = static_cast<Index>(std::lround(until / 100.0 / delta));
  for (Index i = 0; i < x.size(); ++i) {
    for (Index k = 0; k < every; ++k) algorithm.step();
    x[i] = algorithm.motion().x[force_at];
  }
  return x;
}

double error(const VectorXd& x, const VectorXd& exact) { return (x - exact).cwiseAbs().maxCoeff() / exact.cwiseAbs().maxCoeff(); }

void compare_algorithms(const JointType& type, const std::vector<double>& deltas, bench::Promises& promises) {
  const JointedStructure structure = structure_of(type);
  VectorXd exact;
  const double time = bench::seconds([&] { exact = exact_motion(structure, {}); });
  const double own = error(exact, exact_motion(structure, {.longest_step = 5e-6, .mismatch = 1e-11}));
  fmt::print("{:<6}{:<14}{:>10}{:>12.1e}{:>12.2f}\n", type.name, "event-exact", "", own, 1e3 * time);
  promises.at_most(type.name + ": event-exact marching against shorter steps", own, 1e-9);
  std::vector<double> errors;
  for (const double delta : deltas) {
    VectorXd x;
    double solutions = 0.0, growth = 0.0;
    const double one = bench::seconds([&] {
      AlgorithmOne algorithm(structure, sine(), delta);
      x = steps_of(algorithm, delta);
      solutions = static_cast<double>(algorithm.solutions()) * delta / until;
    });
    errors.push_back(error(x, exact));
    fmt::print("{:<6}{:<14}{:>10.0e}{:>12.1e}{:>12.2f}   {:.2f} solutions a step\n", "", "One", delta, errors.back(), 1e3 * one,
               solutions);
    if (type.name == "D" && delta == 5e-5) promises.at_most("D: Algorithm One at 5e-5 s", errors.back(), 0.05);
    const double two = bench::seconds([&] {
      AlgorithmTwo algorithm(structure, sine(), delta);
      x = steps_of(algorithm, delta);
      growth = algorithm.growth();
    });
    fmt::print("{:<6}{:<14}{:>10.0e}{:>12.1e}{:>12.2f}   growth {:.5f}\n", "", "Two", delta, error(x, exact), 1e3 * two, growth);
    promises.at_most(fmt::format("{}: growth of Algorithm Two at {:.0e} s", type.name, delta), growth, 1.0);
  }
  // From 2e-4 s on; the sticking of very stiff joints is seen by the shortest steps only.
  const double order = std::log(errors[1] / errors.back()) / std::log(deltas[1] / deltas.back());
  promises.at_least(type.name + ": order of Algorithm One", order, 1.2);
}

void steady_state(const JointType& type, bench::Promises& promises) {
  const PeriodicProblem problem{structure_of(type), omega, {1}, Complex(0.0, -1.0) * VectorXd::Unit(18, force_at)};
  PeriodicOrbit orbit;
  const double time = bench::seconds([&] { orbit = find_orbit(problem); });
  promises.holds(type.name + ": the orbit closes", orbit.closed);
  if (!orbit.closed) return;
  const OrbitFigures found = figures(problem, orbit, {1});
  const double energy = std::abs(found.work - found.loss.sum() - found.damping_loss) / found.work;
  fmt::print("{:<6}{:>14.6e}{:>10}{:>10}{:>8}{:>12.1e}{:>12.1e}{:>10.4f}{:>12.0f}\n", type.name, found.largest[force_at],
             orbit.periods, orbit.newton_steps, orbit.events, orbit.closure, energy, std::abs(orbit.multipliers[0]), 1e3 * time);
  // A, which loses little of what it stores, to the rounding of the latter.
  promises.at_most(type.name + ": energy of the orbit", energy, type.name == "A" ? 1e-11 : 1e-12);
  promises.at_most(type.name + ": largest |x5|", std::abs(found.largest[force_at] / type.largest - 1.0), 2e-6);
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run(argc, argv, "", [](const bench::CommandLine& line, bench::Promises& promises) {
    std::vector<double> deltas = {1e-3, 2e-4, 5e-5, 1e-5};
    if (!line.quick()) deltas.push_back(2e-6);
    fmt::print("From rest to {} s: largest difference of x5 in parts of its largest, 100 times\n", until);
    fmt::print("{:<6}{:<14}{:>10}{:>12}{:>12}\n", "type", "", "step, s", "error", "time, ms");
    for (const JointType& type : types) compare_algorithms(type, deltas, promises);
    fmt::print("\nSteady state\n{:<6}{:>14}{:>10}{:>10}{:>8}{:>12}{:>12}{:>10}{:>12}\n", "type", "max |x5|, m", "periods",
               "Newton", "events", "closure", "energy", "largest μ", "time, ms");
    for (const JointType& type : types) steady_state(type, promises);
  });
}
