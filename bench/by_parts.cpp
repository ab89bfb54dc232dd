// Likelihood by parts over many seeds of a chain of five joints, 1 and 5 % noise, and the full likelihood beside it on some of them:
// cover of the 95 % intervals, rms of the errors over those stated and over the Cramér–Rao bound, χ², time; loose joints by sensors at all
// joints, and by eigenfrequencies alone. docs/many-joints.md, docs/admissible-joints.md.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "base/complex.hpp"
#include "base/random.hpp"
#include "bench/bench.hpp"
#include "ident/identify.hpp"
#include "ident/newton/loose_path.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/case/many_joints_problem.hpp"
#include "problems/structure/modes.hpp"
#include "tasks/bound_report.hpp"

namespace {

using namespace jointid;

problems::Problem chain(double level) {
  problems::Problem problem = problems::many_joints_problem(problems::chain_of_beams({.joints = 5, .spacing = 1}), {"chain-5", ""}, false);
  std::get<frf::NoiseModel>(problem.noise).level = level;
  return problem;
}

ident::Scene scene_of(const problems::Problem& problem, ident::Solver solver) {
  ident::Scene scene = problems::scene(problem);
  const frf::NoiseModel& noise = std::get<frf::NoiseModel>(problem.noise);
  scene.noise = ident::NoiseSection{.model = frf::name(noise.kind), .level = noise.level, .frf_model = noise};
  scene.identify.method = ident::Method::likelihood;
  scene.identify.solver = solver;
  return scene;
}

ident::Control quick() {
  ident::Control control;
  control.threads = 1;
  control.detail = ident::Detail::estimates;
  control.judgement = ident::Judgement::none;
  return control;
}

struct Row {
  double covered = 0.0, count = 0.0, ratio = 0.0, seconds = 0.0;
  std::vector<double> squares, stated, bound;  ///< by unknown: Σ error², Σ stated error², the Cramér–Rao bound
  std::size_t usable = 0;

  double median_rms() const {
    std::vector<double> shares;
    for (std::size_t u = 0; u < squares.size(); ++u) shares.push_back(std::sqrt(squares[u] / stated[u]));
    return median(shares);
  }

  double median_over_bound() const {
    std::vector<double> shares;
    for (std::size_t u = 0; u < squares.size(); ++u)
      shares.push_back(std::sqrt(squares[u] / static_cast<double>(usable)) / bound[u]);
    return median(shares);
  }
};

/// That of the solver, at the truth: of the likelihood by parts each FRF has a true value of its own.
std::vector<double> bounds(const problems::Problem& problem, const ident::Scene& scene) {
  const auto plan = problems::plan(scene, {problem.substructures, problem.assembly});
  std::vector<double> out;
  for (const tasks::UnknownBound& each : tasks::predict_bound(*plan, {}, quick()).unknowns) out.push_back(each.bound);
  return out;
}

Row measure(double level, ident::Solver solver, std::size_t seeds) {
  const problems::Problem problem = chain(level);
  const ident::Scene scene = scene_of(problem, solver);
  Row row;
  row.squares.assign(problem.unknowns.size(), 0.0);
  row.stated = row.squares;
  row.bound = bounds(problem, scene);
  const ident::Control control = quick();
  for (std::size_t seed = 1; seed <= seeds; ++seed) {
    const auto plan = problems::plan(scene, problems::polluted(problem, seed, 0));
    const double before = bench::processor_seconds();
    const ident::Solution found = ident::solve(*plan, control);
    row.seconds += bench::processor_seconds() - before;
    if (!is_usable(found.status) || !found.unknowns.front().std_error) continue;
    ++row.usable;
    row.ratio += found.fit.chi_square->value / found.fit.chi_square->degrees_of_freedom;
    for (std::size_t u = 0; u < problem.unknowns.size(); ++u) {
      const ident::Estimate& estimate = found.unknowns[u];
      const double error = estimate.value - problem.unknowns[u].value;
      row.squares[u] += error * error;
      row.stated[u] += *estimate.std_error * *estimate.std_error;
      row.covered += (*estimate.ci95)[0] <= problem.unknowns[u].value && problem.unknowns[u].value <= (*estimate.ci95)[1];
      row.count += 1.0;
    }
  }
  return row;
}

/// In how many seeds the three loose joints of loose-3 are named first.
void measure_loose(const bench::CommandLine& line, bench::Promises& promises) {
  const std::size_t seeds = line.count(2, 20, 1);
  problems::Problem problem = problems::make_many_joints("loose-3");
  for (const double level : {0.01, 0.05}) {
    std::get<frf::NoiseModel>(problem.noise).level = level;
    ident::Scene scene = scene_of(problem, ident::Solver::automatic);
    std::size_t named = 0;
    double seconds = 0.0, least_sure = 1.0, most_sound = 0.0;
    for (std::size_t seed = 1; seed <= seeds; ++seed) {
      const auto plan = problems::plan(scene, problems::polluted(problem, seed, 0));
      const double before = bench::processor_seconds();
      const ident::Solution found = ident::solve(*plan, quick());
      seconds += bench::processor_seconds() - before;
      std::vector<std::string> first;
      for (std::size_t k = 0; k < 3 && k < found.loose.size(); ++k) first.push_back(found.loose[k].joint);
      std::ranges::sort(first);
      named += first == std::vector<std::string>{"j12", "j27", "j38"};
      if (found.loose.size() < 4) continue;
      least_sure = std::min(least_sure, found.loose[2].probability);
      most_sound = std::max(most_sound, found.loose[3].probability);
    }
    fmt::print("loose-3, {} %: the three first in {} of {} seeds; least probability {:.3g}, largest of another {:.3g}; {:.3g} s\n",
               100.0 * level, named, seeds, least_sure, most_sound, seconds / static_cast<double>(seeds));
    std::fflush(stdout);
    promises.at_least(fmt::format("loose-3, {} %: named first", 100.0 * level), static_cast<double>(named),
                      0.95 * static_cast<double>(seeds));
  }
}

/// loose-3 of one element a beam, its nominal joints as shares.
struct UndampedChain {
  problems::ManyJoints nominal = problems::chain_of_beams({.beam = {.elements = 1}});
  ident::SharedStiffness shared;

  UndampedChain() {
    problems::Structure parts = nominal.parts.front();
    for (std::size_t s = 1; s < nominal.parts.size(); ++s) parts = merged(parts, nominal.parts[s]);
    const auto n = static_cast<Eigen::Index>(parts.size());
    using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    shared.mass = Eigen::Map<const Rows>(parts.matrix(problems::Kind::mass).data(), n, n);
    shared.stiffness = Eigen::Map<const Rows>(parts.matrix(problems::Kind::stiffness).data(), n, n);
    for (const problems::BeamJoint& joint : nominal.joints) {
      const problems::Matrix k = joint.over_dofs(joint.relative_stiffness);
      const auto place = [&](std::size_t i) { return static_cast<Eigen::Index>(parts.index(joint.dofs[i])); };
      auto& elements = shared.of_joint.emplace_back();
      for (std::size_t r = 0; r < k.size(); ++r) {
        for (std::size_t c = 0; c < k.size(); ++c) elements.push_back({place(r), place(c), k[r][c]});
      }
    }
  }
};

/// In how many seeds forty frequencies name the three loose joints first.
void measure_loose_by_frequencies(const bench::CommandLine& line, bench::Promises& promises) {
  const std::size_t seeds = line.count(3, 10, 1);
  constexpr Eigen::Index frequencies = 40;
  const UndampedChain chain;
  Eigen::VectorXd lost = Eigen::VectorXd::Zero(50);
  lost[11] = 0.7;
  lost[26] = 0.5;
  lost[37] = 0.8;
  const auto hertz = [](double logarithm) { return std::exp(0.5 * logarithm) / angular(1.0); };
  const Eigen::VectorXd exact = ident::elastic_modes(chain.shared, lost, frequencies).logarithm;
  for (const double error : {1e-4, 1e-3}) {
    std::size_t named = 0, solutions = 0;
    double off = 0.0, sound = 0.0;
    const double before = bench::processor_seconds();
    for (std::size_t seed = 1; seed <= seeds; ++seed) {
      std::vector<double> hz;
      for (Eigen::Index r = 0; r < frequencies; ++r)
        hz.push_back(hertz(exact[r]) * (1.0 + error * normal_numbers({.seed = seed}, static_cast<std::uint64_t>(r))[0]));
      const ident::LooseFit fit = ident::fit_loose_joints(chain.shared, hz, [] {});
      solutions += fit.solutions;
      std::vector<double> others, loose;
      for (Eigen::Index e = 0; e < 50; ++e) (lost[e] > 0.0 ? loose : others).push_back(fit.lost[e]);
      const double largest = *std::ranges::max_element(others);
      named += *std::ranges::min_element(loose) > largest;
      sound = std::max(sound, largest);
      for (const Eigen::Index e : {11, 26, 37}) off = std::max(off, std::abs(fit.lost[e] - lost[e]));
    }
    const auto count = static_cast<double>(seeds);
    fmt::print("40 frequencies to {}: the three first in {} of {} seeds; shares at most {:.2g} off, largest of another {:.2g}; {:.0f} "
               "solutions, {:.3g} s\n",
               error, named, seeds, off, sound, static_cast<double>(solutions) / count, (bench::processor_seconds() - before) / count);
    std::fflush(stdout);
    promises.at_least(fmt::format("40 frequencies to {}: named first", error), static_cast<double>(named), 0.9 * count);
  }
}

void measure_all(const bench::CommandLine& line, bench::Promises& promises) {
  const std::size_t seeds = line.count(0, 200, 4), beside = line.count(1, 20, 1);
  fmt::print("| noise | solver | seeds | usable | coverage | median rms over stated | over the bound | χ² over f | s |\n");
  for (const double level : {0.01, 0.05}) {
    for (const ident::Solver solver : {ident::Solver::by_parts, ident::Solver::gauss_helmert}) {
      const bool parts = solver == ident::Solver::by_parts;
      const std::size_t count = parts ? seeds : beside;
      const Row row = measure(level, solver, count);
      const auto usable = static_cast<double>(row.usable);
      const double covered = row.covered / row.count, rms = row.median_rms();
      fmt::print("| {} % | {} | {} | {} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.3g} |\n", 100.0 * level, ident::name(solver), count,
                 row.usable, covered, rms, row.median_over_bound(), row.ratio / usable, row.seconds / static_cast<double>(count));
      std::fflush(stdout);
      if (!parts) continue;
      const std::string name = fmt::format("{} %", 100.0 * level);
      promises.at_least(name + ": usable", usable / static_cast<double>(count), 1.0);
      promises.at_least(name + ": coverage", covered, line.quick() ? 0.8 : 0.93);
      promises.at_most(name + ": coverage", covered, line.quick() ? 1.0 : 0.97);
      promises.at_most(name + ": median rms over stated", rms, line.quick() ? 2.0 : 1.25);
      promises.at_most(name + ": median rms over the bound", row.median_over_bound(), line.quick() ? 2.0 : 1.25);
    }
  }
  measure_loose(line, promises);
  measure_loose_by_frequencies(line, promises);
}

}  // namespace

int main(int argc, char** argv) {
  return jointid::bench::run(argc, argv, "[SEEDS [SEEDS-OF-THE-FULL-LIKELIHOOD [SEEDS-OF-LOOSE-3 [SEEDS-OF-FREQUENCIES]]]]", measure_all);
}
