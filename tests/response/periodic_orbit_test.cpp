#include "response/orbit/periodic_orbit.hpp"

#include <gtest/gtest.h>

#include "golden.hpp"
#include "response/orbit/orbit_figures.hpp"

namespace jointid::response {
namespace {

using Eigen::VectorXd;
using nlohmann::json;

PeriodicProblem problem_of(const json& one) {
  PeriodicProblem problem;
  if (one.contains("m")) {
    problem.structure.matrices = {matrix(one.at("m")), matrix(one.at("c")), matrix(one.at("k"))};
    problem.structure.incidence = Eigen::MatrixXd::Ones(1, 1);
    problem.structure.laws = {law(one)};
    problem.harmonics = {1};
    problem.amplitudes = Eigen::MatrixXcd::Constant(1, 1, one.at("P").get<double>());
  } else {
    problem.structure = jointed(one);
    problem.amplitudes.resize(problem.structure.coordinates(), at(one.at("P").size()));
    for (const auto& [n, amplitude] : one.at("P").items()) {
      problem.amplitudes.col(at(problem.harmonics.size())) = complex_vector(amplitude);
      problem.harmonics.push_back(std::stoi(n));
    }
  }
  problem.omega = one.at("omega");
  return problem;
}

/// X, F of a case: harmonics × coordinates (one coordinate: harmonics).
Eigen::MatrixXcd by_harmonic(const json& rows, Eigen::Index width) {
  Eigen::MatrixXcd out(width, rows.size());
  for (std::size_t h = 0; h < rows.size(); ++h) {
    out.col(at(h)) = width == 1 && rows[h][0].is_number() ? Eigen::VectorXcd::Constant(1, complex_number(rows[h])) : complex_vector(rows[h]);
  }
  return out;
}

void compare(const json& one, const json& values, double tol) {
  const PeriodicProblem problem = problem_of(one);
  const PeriodicOrbit orbit = find_orbit(problem);
  printf("%s status %d closure %g periods %d newton %d events %zu free:", one.at("id").get<std::string>().c_str(), static_cast<int>(orbit.status), orbit.closure, orbit.periods, orbit.newton_steps, orbit.events);
  for (bool f : orbit.residual_force_free) printf(" %d", f ? 1 : 0);
  ASSERT_EQ(orbit.status, OrbitStatus::closed);
  const OrbitFigures found = figures(problem, orbit, values.at("harmonics").get<std::vector<int>>());
  const Eigen::Index n = problem.structure.coordinates(), joints = problem.structure.joints();
  const Eigen::MatrixXcd x = by_harmonic(values.at("X"), n), f = by_harmonic(values.at("F"), joints);
  const double energy = std::abs(found.work - found.loss.sum() - found.damping_loss) / found.work;
  printf(" X %g F %g energy %g ", difference(found.x, x), difference(found.f, f), energy);
  EXPECT_LT(difference(found.x, x), tol);
  EXPECT_LT(difference(found.f, f), tol);
  EXPECT_LT(energy, 1e-12);
  const VectorXd largest = values.at("x_max").is_array() ? vector(values.at("x_max")) : VectorXd::Constant(1, values.at("x_max").get<double>());
  printf(" xmax %g ", difference(found.largest, largest));
  const VectorXd loss = values.at("dissipated").is_array() ? vector(values.at("dissipated")) : VectorXd::Constant(1, values.at("dissipated").get<double>());
  printf(" loss %g ", difference(found.loss, loss));
  if (values.contains("floquet")) {
    const VectorXd moduli = vector(values.at("floquet"));
    ASSERT_GE(orbit.multipliers.size(), moduli.size());
    printf(" mult %g ", difference(orbit.multipliers.head(moduli.size()).cwiseAbs(), moduli));
  } else { printf(" mu1 %g of %ld", orbit.multipliers.size() ? std::abs(orbit.multipliers[0]) : 0, orbit.multipliers.size()); }
  printf("\n");
}

TEST(PeriodicOrbit, MeetsTheGoldenOrbits) {
  for (const std::string kind : {"sdof_jenkins_exact", "mdof_jenkins_exact"}) {
    for_each_golden(kind, [](const json& one) {
      SCOPED_TRACE(one.at("id").get<std::string>());
      compare(one, one, tolerance(one));
    });
  }
  for_each_golden("masing_steady", [](const json& one) {
    SCOPED_TRACE(one.at("id").get<std::string>());
    compare(one, one.at("exact"), tolerance(one.at("exact")));
  });
}

}  // namespace
}  // namespace jointid::response
