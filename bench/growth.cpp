// How the cost of one solution (assembling and solving, one thread) grows with the size of the problem, on random FRFs.
// The exponent is log(time ratio) / log(size ratio). The assembly's FRFs are those with a random joint, so that the error of the
// joint found stands beside the time. Promised: it is 1e-9 at most, and cost grows no faster than docs/cost.md says.
#include <fmt/core.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <random>

#include "bench/bench.hpp"
#include "dense/lu.hpp"
#include "ident/identify.hpp"

namespace {

using namespace jointid;

struct Size {
  std::size_t lines = 100, other = 20, joint = 6;
  restrictions::Pattern pattern = restrictions::Pattern::symmetric;
};

frf::FrfSet random_set(std::size_t lines, std::size_t dofs, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  frf::FrfSet set;
  for (std::size_t i = 0; i < lines; ++i) set.header.frequency_hz.push_back(100.0 + static_cast<double>(i));
  for (std::size_t i = 0; i < dofs; ++i) set.header.response.push_back({static_cast<std::int64_t>(i + 1), frf::Direction::y, +1});
  set.header.reference = set.header.response;
  for (std::size_t i = 0; i < lines * dofs * dofs; ++i) set.values.emplace_back(normal(generator), normal(generator));
  return set;
}

using RowMatrix = Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The FRFs with the joint k between the first coordinates: (6.15) of docs/formulas.md.
frf::FrfSet with_joint(frf::FrfSet set, const Eigen::MatrixXd& k) {
  const auto dofs = static_cast<Eigen::Index>(set.header.response.size());
  for (std::size_t line = 0; line < set.header.lines(); ++line) {
    Eigen::Map<RowMatrix> h(set.values.data() + set.index(line, 0, 0), dofs, dofs);
    const Eigen::MatrixXcd z = k.cast<Complex>(), at_joint = h.topLeftCorner(k.rows(), k.cols());
    const Eigen::MatrixXcd i = Eigen::MatrixXcd::Identity(k.rows(), k.cols());
    h -= (h.leftCols(k.rows()) * dense::solve(i + z * at_joint, z * h.topRows(k.rows()))).eval();
  }
  return set;
}

/// Quickest time of a solution, and the largest error of an unknown in parts of the largest unknown.
struct Run {
  double milliseconds = 0.0, error = 0.0;
};

Run solve(const Size& size, bool quick) {
  ident::Scene scene;
  restrictions::JointSpec joint;
  for (std::size_t i = 0; i < size.joint; ++i) joint.dofs.push_back({static_cast<std::int64_t>(i + 1), frf::Direction::y, +1});
  joint.matrices[restrictions::Kind::stiffness] = size.pattern;
  scene.joints = {joint};
  scene.identify.equations = {ident::Equation::nn, ident::Equation::nj};
  const restrictions::Restriction restriction = restrictions::build(scene.joints);
  std::mt19937 generator(3);
  std::normal_distribution<double> normal;
  std::vector<double> truth(restriction.unknowns.size());
  for (double& value : truth) value = normal(generator);
  const std::vector<double> k = restriction.matrix(restrictions::Kind::stiffness, truth);
  const auto n = static_cast<Eigen::Index>(size.joint);
  const frf::FrfSet parts = random_set(size.lines, size.joint + size.other, 1);
  const auto plan = ident::make_plan(
      scene, {parts},
      {with_joint(parts, Eigen::Map<const Eigen::Matrix<double, -1, -1, Eigen::RowMajor>>(k.data(), n, n))});
  ident::Control control;
  control.threads = 1;
  control.detail = ident::Detail::estimates;
  std::vector<double> times, found;
  const auto begin = Clock::now();
  for (int round = 0; round < (quick ? 1 : 50) && (round < 3 || seconds_since(begin) < 1.0); ++round) {
    const ident::Solution solution = ident::solve(*plan, control);
    times.push_back(1e3 * solution.runtime_s.total);
    found.clear();
    for (const ident::Estimate& estimate : solution.unknowns) found.push_back(estimate.value);
  }
  return {bench::least(times), bench::largest_difference(found, truth, 0, truth.size())};
}

struct Step {
  double size = 0.0;
  Size problem;
};

/// `most`: the exponent over the last step that the documentation promises.
void print(const char* what, const std::vector<Step>& steps, double most, const bench::CommandLine& line,
           bench::Promises& promises) {
  fmt::print("{:34}", what);
  std::vector<double> times;
  double error = 0.0;
  for (const Step& step : steps) {
    const Run run = solve(step.problem, line.quick());
    times.push_back(run.milliseconds);
    fmt::print("  {:5g}: {:9.3f} ms", step.size, run.milliseconds);
    promises.at_most(fmt::format("{} {}: error of the joint", step.size, what), run.error, 1e-9);
    error = std::max(error, run.error);
  }
  const std::size_t last = steps.size() - 1;
  const double exponent = std::log(times[last] / times[last - 1]) / std::log(steps[last].size / steps[last - 1].size);
  fmt::print("   exponent {:.2f}, over the last step {:.2f}; largest error {:.1e}\n",
             std::log(times[last] / times[0]) / std::log(steps[last].size / steps[0].size), exponent, error);
  promises.speed_at_most(fmt::format("exponent of {} over the last step", what), exponent, most);
}

void measure(const bench::CommandLine& line, bench::Promises& promises) {
  using enum restrictions::Pattern;
  fmt::print("one solution, WB, nn + nj; if not said otherwise 100 lines, 20 non-joint and 6 joint coordinates, symmetric K\n");
  const auto grow = [&](const char* what, const std::vector<Step>& steps, double most) {
    print(what, steps, most, line, promises);
  };
  grow("lines", {{100, {.lines = 100}}, {300, {.lines = 300}}, {1000, {.lines = 1000}}}, 1.2);
  grow("non-joint coordinates", {{20, {.other = 20}}, {60, {.other = 60}}, {200, {.other = 200}}}, 2.0);
  grow("joint coordinates, symmetric K", {{4, {.joint = 4}}, {8, {.joint = 8}}, {12, {.joint = 12}}}, 6.0);
  grow("unknowns, 10 joint coordinates",
       {{10, {.joint = 10, .pattern = diagonal}},
        {55, {.joint = 10, .pattern = symmetric}},
        {100, {.joint = 10, .pattern = full}}},
       2.0);
}

}  // namespace

int main(int argc, char** argv) { return bench::run(argc, argv, "", measure); }
