// The ways to the periodic response of the thesis's 18-DOF structure, error against run time: harmonic balance to 1, 3, 5 and 9
// harmonics, Algorithms One and Two from rest until they settle, event-exact marching with Newton's method (docs/response-ways.md).
// Cases of §11: types A to E under p sin 100πt with p = 1, B with 2 and 100, D with 100, B under sines of 50, 150 and 250 Hz.
// Promised: exact orbits close; the largest |x₅| of the sheet; type B low by 19 % with one harmonic and by 0.37 % with nine, C high by
// 29 % and 0.78 %, E by −10 % and 0.04 %; both algorithms of order 1.5 at least on A, B and E. The quick run leaves the shortest steps
// and the slow cases out.
#include <fmt/core.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "bench/bench.hpp"
#include "friction/law/laws.hpp"
#include "problems/thesis/two_beams.hpp"
#include "response/comparison/compare_ways.hpp"
#include "response/structure/modal_damping.hpp"

namespace {

using namespace jointid;
using namespace jointid::response;

struct Case {
  std::string name, beams;
  double level;
  std::vector<int> harmonics;            ///< of the force, sines
  double largest;                        ///< max |x₅| of the sheet, m; 0: not there
  double first, ninth, tolerance;        ///< errors of harmonic balance, in parts; tolerance 0: not there
  bool slow;
};

const std::vector<Case> cases = {{"A, 1 N", "beams-A", 1.0, {1}, 2.472486e-6, 0.0, 0.0, 1e-5, false},
                                 {"B, 1 N", "beams-B", 1.0, {1}, 1.859820e-6, -0.19, -0.0037, 0.005, false},
                                 {"C, 1 N", "beams-C", 1.0, {1}, 1.150651e-6, 0.29, 0.0078, 0.005, true},
                                 {"D, 1 N", "beams-D", 1.0, {1}, 1.159558e-6, 0.0, 0.0, 0.0, true},
                                 {"E, 1 N", "beams-E", 1.0, {1}, 1.80356e-6, -0.10, 0.0004, 0.005, true},
                                 {"B, 2 N", "beams-B", 2.0, {1}, 0.0, 0.0, 0.0, 0.0, true},
                                 {"B, 100 N", "beams-B", 100.0, {1}, 0.0, 0.0, 0.0, 0.0, true},
                                 {"D, 100 N", "beams-D", 100.0, {1}, 0.0, 0.0, 0.0, 0.0, true},
                                 {"B, 1 N each of 50, 150, 250 Hz", "beams-B", 1.0, {1, 3, 5}, 0.0, 0.0, 0.0, 0.0, true}};

Eigen::MatrixXd dense_matrix(const problems::Matrix& rows) {
  Eigen::MatrixXd all(at(rows.size()), at(rows.size()));
  for (Eigen::Index i = 0; i < all.rows(); ++i) {
    for (Eigen::Index j = 0; j < all.cols(); ++j) all(i, j) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  }
  return all;
}

MatrixAssembly assembly_of(const std::string& name) {
  const problems::TwoBeams& type = *problems::find_two_beams(name);
  const Eigen::MatrixXd mass = dense_matrix(problems::two_beams_mass()), stiffness = dense_matrix(problems::two_beams_stiffness());
  MatrixAssembly all = {{mass, modal_damping(mass, stiffness, 0.01), stiffness}, Eigen::MatrixXd::Zero(18, 2), {}, {}};
  all.w(4, 0) = all.w(6, 1) = 1.0;
  all.w(12, 0) = -1.0;
  all.joints.assign(2, {.name = name, .friction = friction::make_element(type.law, type.parameters)});
  all.forces = Eigen::VectorXd::Unit(18, 4);
  return all;
}

/// Order by which the error of an algorithm falls from its first step to its last.
double order_of(const std::vector<WayResult>& ways, const std::string& name, const std::vector<int>& steps) {
  std::vector<double> errors;
  for (const WayResult& way : ways) {
    if (way.way.starts_with(name) && way.found) errors.push_back(way.of_amplitude);
  }
  if (errors.size() < 2) return 0.0;
  return std::log(errors.front() / errors[1]) / std::log(static_cast<double>(steps[1]) / steps[0]);
}

void measure(const Case& each, bool quick, bench::Promises& promises) {
  const Eigen::MatrixXcd sines = Eigen::MatrixXcd::Constant(at(each.harmonics.size()), 1, Complex(0.0, -1.0));
  WaysAsked asked;
  if (quick) asked.steps_per_period = {100, 1000};
  const auto ways = compare_ways(assembly_of(each.beams), {each.harmonics, sines}, 100.0 * std::numbers::pi, each.level,
                                 Eigen::VectorXd::Unit(18, 4), asked);
  fmt::print("\n{}\n  {:<24}{:>14}{:>11}{:>11}{:>11}{:>11}{:>9}\n", each.name, "way", "max |x5| m", "its error", "of X1", "of x(t)",
             "time ms", "periods");
  for (const WayResult& way : ways) {
    if (!way.found) {
      fmt::print("  {:<24}{:>14}{:>44.3g}\n", way.way, "not found", 1e3 * way.seconds);
      continue;
    }
    fmt::print("  {:<24}{:>14.6e}{:>11.1e}{:>11.1e}{:>11.1e}{:>11.3g}{:>9.0f}\n", way.way, way.largest, way.of_largest, way.of_amplitude,
               way.of_motion, 1e3 * way.seconds, way.periods);
  }
  promises.holds(each.name + ": the exact orbit closes", ways.front().found);
  if (!ways.front().found) return;
  if (each.largest > 0.0) promises.at_most(each.name + ": largest |x5|", std::abs(ways.front().largest / each.largest - 1.0), 2e-6);
  if (each.tolerance > 0.0) {
    promises.at_most(each.name + ": harmonic 1", std::abs(ways[1].of_largest - each.first), each.tolerance);
    promises.at_most(each.name + ": harmonics to 9", std::abs(ways[4].of_largest - each.ninth), 0.1 * each.tolerance);
    if (each.name.starts_with("C")) return;  // its sticking is seen by the shortest steps alone
    for (const char* name : {"Algorithm One", "Algorithm Two"}) {
      promises.at_least(each.name + ": order of " + name, order_of(ways, name, asked.steps_per_period), 1.5);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run(argc, argv, "", [](const bench::CommandLine& line, bench::Promises& promises) {
    for (const Case& each : cases) {
      if (!line.quick() || !each.slow) measure(each, line.quick(), promises);
    }
  });
}
