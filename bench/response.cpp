// Harmonic balance condensed to the joints with event-exact Fourier integrals: time of a point of a sweep beside numpy with
// sampled forces (AFT, 1024 samples) and the same Newton steps, and the error that the samples leave; cost of a Newton step
// against the number of coordinates. Promised: SDOF with a bilinear joint and harmonics to 9 at most 0.2 ms a point, Iwan with
// harmonics to 3 1 ms, 18 DOF with two joints, 400 lines and harmonics to 9 0.5 s; a step of 1800 coordinates takes at most 1.5
// times that of 18. The quick run takes a tenth of the lines.
#include <fmt/core.h>

#include <cmath>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "bench/bench.hpp"
#include "friction/law/laws.hpp"
#include "response/continuation/sweep.hpp"
#include "response/structure/matrix_receptance.hpp"
#include "response/structure/sparse_receptance.hpp"
#include "tests/test_folder.hpp"

namespace {

using namespace jointid;
using namespace jointid::response;

struct Case {
  std::string name, law;
  std::vector<double> parameters;
  MatrixStructure structure;
  Eigen::MatrixXd joints;
  double amplitude = 1.0;
  std::vector<int> harmonics;
  std::vector<double> omegas;
  double promised_ms = 0.0;  ///< a point
};

std::vector<double> between(double from, double to, std::size_t count) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i)
    values.push_back(from + (to - from) * static_cast<double>(i) / static_cast<double>(count - 1));
  return values;
}

/// n masses of 1 kg between springs of 1000 N/m, the first to ground.
MatrixStructure chain(Eigen::Index n) {
  MatrixStructure s = {Eigen::MatrixXd::Identity(n, n), {}, Eigen::MatrixXd::Zero(n, n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    s.stiffness(i, i) += 1000.0;
    if (i == 0) continue;
    s.stiffness(i - 1, i - 1) += 1000.0;
    s.stiffness(i, i - 1) = s.stiffness(i - 1, i) = -1000.0;
  }
  s.damping = 2e-4 * s.stiffness + 0.05 * s.mass;
  return s;
}

/// From coordinate 5 to ground and between 7 and 13.
Eigen::MatrixXd two_joints(Eigen::Index n) {
  Eigen::MatrixXd w = Eigen::MatrixXd::Zero(n, 2);
  w(4, 0) = 1.0;
  w(6, 1) = 1.0;
  w(12, 1) = -1.0;
  return w;
}

Eigen::MatrixXd unit(Eigen::Index n, Eigen::Index place) {
  Eigen::MatrixXd column = Eigen::MatrixXd::Zero(n, 1);
  column(place, 0) = 1.0;
  return column;
}

std::vector<Case> cases(std::size_t lines) {
  const Eigen::MatrixXd one = Eigen::MatrixXd::Ones(1, 1);
  const MatrixStructure single = {one, 0.01 * one, 0.75 * one};
  return {{"SDOF, bilinear, harmonics to 9",
           "bilinear",
           {0.8, 0.25},
           single,
           one,
           0.3,
           {1, 3, 5, 7, 9},
           between(0.5, 1.3, lines),
           0.2},
          {"SDOF, Iwan, harmonics to 3", "iwan", {0.2, 0.25, -0.5, 0.2}, single, one, 0.3, {1, 3}, between(0.5, 1.3, lines), 1.0},
          {"18 DOF, two bilinear joints, harmonics to 9",
           "bilinear",
           {0.002, 800.0},
           chain(18),
           two_joints(18),
           5.0,
           {1, 3, 5, 7, 9},
           between(2.0, 12.0, lines),
           1.25}};
}

std::vector<Joint> joints_of(const Case& each) {
  const Joint joint = {.name = each.law, .friction = friction::make_element(each.law, each.parameters)};
  return std::vector<Joint>(static_cast<std::size_t>(each.joints.cols()), joint);
}

HarmonicBalance balance_of(const Case& each) {
  const Eigen::MatrixXd place = unit(each.structure.mass.rows(), 0);
  return {std::make_shared<MatrixReceptance>(each.structure, each.joints, place, place),
          joints_of(each),
          Excitation::single(each.amplitude),
          {.fixed = each.harmonics}};
}

nlohmann::json rows(const Eigen::MatrixXd& matrix) {
  nlohmann::json all = nlohmann::json::array();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    const Eigen::RowVectorXd row = matrix.row(i);
    all.push_back(std::vector<double>(row.begin(), row.end()));
  }
  return all;
}

void compare(const Case& each, bool quick, bench::Promises& promises) {
  const HarmonicBalance balance = balance_of(each);
  std::vector<HarmonicSolution> solutions;
  std::vector<double> times;
  for (int round = 0; round < (quick ? 1 : 5); ++round) {
    const double before = bench::processor_seconds();
    solutions = sweep(balance, each.omegas, 1.0);
    times.push_back(bench::processor_seconds() - before);
  }
  const double points = static_cast<double>(each.omegas.size()), ours = 1e3 * bench::least(times) / points;
  double steps = 0.0;
  bool converged = true;
  for (const HarmonicSolution& solution : solutions) {
    steps += solution.steps;
    converged = converged && solution.converged;
  }
  fmt::print("{}, {} frequencies\n  jointid            {:8.4f} ms a point, {:.1f} Newton steps; at most {}\n", each.name,
             each.omegas.size(), ours, steps / points, each.promised_ms);
  promises.holds(each.name + ": all converged", converged);
  promises.speed_at_most(each.name + ", ms a point", ours, each.promised_ms);

  const TestFolder folder;
  std::ofstream(folder / "case.json") << nlohmann::json{{"M", rows(each.structure.mass)},
                                                        {"C", rows(each.structure.damping)},
                                                        {"K", rows(each.structure.stiffness)},
                                                        {"W", rows(each.joints)},
                                                        {"force", 0},
                                                        {"amplitude", each.amplitude},
                                                        {"harmonics", each.harmonics},
                                                        {"omegas", each.omegas},
                                                        {"law", each.law},
                                                        {"parameters", each.parameters}};
  for (const int samples : {1024, 8192}) {
    const auto text = bench::peer_output(fmt::format("response.py {} {}", (folder / "case.json").string(), samples), promises);
    if (!text) return;
    std::istringstream in(*text);
    double seconds = 0.0, lost = 0.0, worst = 0.0, largest = 0.0;
    in >> seconds >> lost;
    for (const HarmonicSolution& solution : solutions) {
      std::string word;  // "nan" where it did not converge
      in >> word;
      const double size = std::abs(solution.response(0, 0)), peer = word == "nan" ? size : std::stod(word);
      worst = std::max(worst, std::abs(peer - size));
      largest = std::max(largest, size);
    }
    const double theirs = 1e3 * seconds / points;
    fmt::print(
        "  numpy, {:4} samples {:8.3f} ms a point, {:.0f} times as long; error of |X| {:.1e} of the peak, {:.0f} not converged\n",
        samples, theirs, theirs / ours, worst / largest, lost);
    promises.at_most(fmt::format("{}: numpy with {} samples differs by its sampling error", each.name, samples), worst / largest,
                     samples == 1024 ? 1e-2 : 1e-3);
  }
}

/// A step: residual, Jacobian and its solution, with the receptances of the frequency at hand.
void step_cost(bool quick, bench::Promises& promises) {
  fmt::print(
      "\none Newton step, two bilinear joints, harmonics to 9\n  coordinates  step µs  receptances of the frequency ms, dense; "
      "sparse; largest difference\n");
  std::vector<double> all;
  for (const Eigen::Index n : quick ? std::vector<Eigen::Index>{18, 180} : std::vector<Eigen::Index>{18, 180, 1800}) {
    const Eigen::MatrixXd place = unit(n, 0);
    const MatrixReceptance structure(chain(n), two_joints(n), place, place);
    const Joint joint = {.name = "joint", .friction = friction::make_element("bilinear", std::vector{0.002, 800.0})};
    const CondensedEquations equations({joint, joint}, Harmonics({1, 3, 5, 7, 9}));
    HarmonicLine line;
    const double receptance =
        bench::seconds([&] { line = harmonic_line(structure, equations.harmonics(), Excitation::single(5.0), 6.0); });
    const SparseReceptance sparse(
        {chain(n).mass.sparseView(), chain(n).damping.sparseView(), chain(n).stiffness.sparseView()}, two_joints(n), place, place);
    HarmonicLine same;
    const double of_sparse =
        bench::seconds([&] { same = harmonic_line(sparse, equations.harmonics(), Excitation::single(5.0), 6.0); });
    double difference = 0.0;
    for (std::size_t i = 0; i < line.harmonics.size(); ++i) {
      const Eigen::MatrixXcd &a = line.harmonics[i].joints, &b = same.harmonics[i].joints;
      difference = std::max(difference, (a - b).cwiseAbs().maxCoeff() / a.cwiseAbs().maxCoeff());
    }
    promises.at_most("sparse receptances are the dense ones", difference, 1e-10);
    const NewtonResult at = newton(equations, line, 1.0, equations.free(line, 1.0));
    promises.holds("the step's case converges", at.converged);
    std::vector<double> times;
    for (int round = 0; round < 60; ++round) {
      times.push_back(1e6 *
                      bench::seconds([&] { newton(equations, line, 1.0, at.motion, {.most_steps = 1, .tolerance = 0.0}); }, 20));
    }
    all.push_back(bench::least(times));
    fmt::print("  {:11}  {:7.1f}  {:.3f}; {:.3f}; {:.0e}\n", n, all.back(), 1e3 * receptance, 1e3 * of_sparse, difference);
  }
  promises.speed_at_most("step of the most coordinates over that of 18", all.back() / all.front(), 1.5);
}

void measure(const bench::CommandLine& line, bench::Promises& promises) {
  for (const Case& each : cases(line.quick() ? 40 : 400)) compare(each, line.quick(), promises);
  step_cost(line.quick(), promises);
}

}  // namespace

int main(int argc, char** argv) { return bench::run(argc, argv, "", measure); }
