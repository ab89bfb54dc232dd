// Many joints under constraints: times of the sparse interior point over the number of unknowns, with the certificate of the
// optimum checked; active sets that are known beforehand; and the cover of intervals where bounds are active.
// docs/admissible-joints.md.
#include <fmt/core.h>

#include <Eigen/Core>
#include <cmath>
#include <random>

#include "bench/bench.hpp"
#include "ident/admissible/profile_interval.hpp"
#include "ident/admissible/sparse_semidefinite.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"
#include "study/trial_loop.hpp"

namespace {

using namespace jointid;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A chain of joints with 2 × 2 K and D each: parts see the six unknowns of the joints on either side.
struct Chain {
  Eigen::SparseMatrix<double> information;
  std::vector<ident::SymmetricBlock> blocks;
  VectorXd answer, estimate;
  std::vector<Index> zeros;  ///< eigenvalues at the limit, per block
};

/// The estimate is that of which a known answer, with known multipliers, is the constrained optimum: half of the blocks at the
/// limit.
Chain chain(Index joints, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const Index n = 6 * joints;
  Chain out;
  std::vector<Eigen::Triplet<double, int>> all;
  for (Index part = 0; part + 1 < joints; ++part) {
    const MatrixXd rows = MatrixXd::NullaryExpr(40, 12, [&] { return normal(random); });
    const MatrixXd own = rows.transpose() * rows;
    for (Index u = 0; u < 12; ++u) {
      for (Index v = 0; v <= u; ++v) all.emplace_back(static_cast<int>(6 * part + u), static_cast<int>(6 * part + v), own(u, v));
    }
  }
  out.information.resize(n, n);
  out.information.setFromTriplets(all.begin(), all.end());
  out.answer.resize(n);
  VectorXd pull = VectorXd::Zero(n);
  for (Index first = 0; first < n; first += 3) {
    const double angle = normal(random), a = 0.2 + std::abs(normal(random)), b = 0.2 + std::abs(normal(random));
    const double c = std::cos(angle), s = std::sin(angle);
    const Index kind = static_cast<Index>(random() % 3);
    Eigen::Matrix2d one, two, x = Eigen::Matrix2d::Zero(), multiplier = Eigen::Matrix2d::Zero();
    one << c * c, c * s, c * s, s * s;
    two << s * s, -c * s, -c * s, c * c;
    (kind < 2 ? x : multiplier) += a * one;
    (kind < 1 ? x : multiplier) += b * two;
    out.answer.segment(first, 3) << x(0, 0), x(0, 1), x(1, 1);
    out.blocks.push_back(
        {MatrixXd::Zero(2, 2), {first, first + 1, first + 2}, {{{0, 0, 1.0}}, {{0, 1, 1.0}, {1, 0, 1.0}}, {{1, 1, 1.0}}}});
    out.blocks.back().add_adjoint(20.0 * multiplier, pull);
    out.zeros.push_back(kind);
  }
  // N⁻¹ pull by conjugate gradients, independent of the factors that are measured.
  VectorXd step = VectorXd::Zero(n), rest = pull, way = rest;
  for (int k = 0; k < 4000 && rest.norm() > 1e-14 * pull.norm(); ++k) {
    const VectorXd product = out.information.selfadjointView<Eigen::Lower>() * way;
    const double before = rest.squaredNorm(), length = before / way.dot(product);
    step += length * way;
    rest -= length * product;
    way = rest + rest.squaredNorm() / before * way;
  }
  out.estimate = out.answer - step;
  return out;
}

/// ‖N(θ − θ̂) − Σ 𝒜*Λ‖ over ‖N(θ − θ̂)‖: with Λ ⪰ 0 and tr SΛ = 0 the proof of the optimum.
double open_of_certificate(const Chain& of, const ident::SemidefiniteFit& fit) {
  VectorXd pull = of.information.selfadjointView<Eigen::Lower>() * (fit.x - of.estimate);
  const double size = pull.norm();
  for (std::size_t k = 0; k < of.blocks.size(); ++k) {
    VectorXd own = VectorXd::Zero(pull.size());
    of.blocks[k].add_adjoint(fit.multiplier[k], own);
    pull -= own;
  }
  return pull.norm() / size;
}

void measure_times(const bench::CommandLine& line, bench::Promises& promises) {
  fmt::print("| unknowns | blocks at the limit | iterations | s | open of the certificate | tr SΛ over cost | largest error |\n");
  std::mt19937_64 random(1);
  for (const Index joints : {Index{10}, Index{50}, Index{200}, Index{1700}}) {
    if (line.quick() && joints > 200) continue;
    const Chain of = chain(joints, random);
    const Clock::time_point start = Clock::now();
    const auto fit = ident::solve_sparse_semidefinite(of.blocks, of.estimate, of.information, 1.0);
    const double seconds = seconds_since(start);
    const double open = fit ? open_of_certificate(of, *fit) : 1.0;
    double least = 0.0;
    const VectorXd moved = fit->x - of.estimate;
    const double cost = moved.dot(of.information.selfadjointView<Eigen::Lower>() * moved);
    for (const MatrixXd& each : fit->multiplier) least = std::min(least, ident::least_eigenvalue(each));
    const double error = (fit->x - of.answer).cwiseAbs().maxCoeff();
    std::size_t at_limit = 0;
    for (const Index each : fit->at_limit) at_limit += each > 0;
    fmt::print("| {} | {} of {} | {} | {:.3g} | {:.2g} | {:.2g} | {:.2g} |\n", 6 * joints, at_limit, of.blocks.size(),
               fit->iterations, seconds, open, fit->gap / cost, error);
    const std::string row = fmt::format("{} unknowns", 6 * joints);
    promises.at_most(row + ": open of the certificate", open, 1e-7);
    promises.at_least(row + ": least eigenvalue of a multiplier", least, -1e-12);
    promises.at_most(row + ": gap over cost", fit->gap / cost, 1e-8);
    if (joints == 200) promises.speed_at_most(row + ": seconds", seconds, 1.0);
  }
}

void measure_active_sets(const bench::CommandLine& line, bench::Promises& promises) {
  const std::size_t seeds = line.count(0, 200, 40);
  std::size_t wrong = 0;
  for (std::size_t seed = 0; seed < seeds; ++seed) {
    std::mt19937_64 random(seed);
    const Chain of = chain(10, random);
    const auto fit = ident::solve_sparse_semidefinite(of.blocks, of.estimate, of.information, 1.0);
    wrong += !fit || !fit->converged || fit->at_limit != of.zeros;
  }
  fmt::print("wrong active sets: {} of {} seeds\n", wrong, seeds);
  promises.at_most("wrong active sets", static_cast<double>(wrong), 0.0);
}

/// A1 by likelihood with the truth on the bounds of every third unknown, or a standard deviation inside: intervals of the bounded
/// unknowns and of the others.
void measure_cover(const bench::CommandLine& line, bench::Promises& promises) {
  const std::size_t trials = line.count(0, 200, 10);
  problems::Problem problem = problems::make("A1");
  auto& noise = std::get<frf::NoiseModel>(problem.noise);
  noise.level = 0.05;
  ident::Scene scene = problems::scene(problem);
  scene.noise = ident::NoiseSection{.model = frf::name(noise.kind), .level = noise.level, .frf_model = noise};
  scene.identify.method = ident::Method::likelihood;
  const auto data = problems::trial_data(scene, problem);
  const auto free = study::run_trials(data, {.trials = 1});
  for (const double inside : {0.0, 1.0}) {
    scene.identify.bounds.clear();
    for (std::size_t u = 0; u < problem.unknowns.size(); u += 3) {
      const auto& ends = *free[0].ci95[u];
      const double deviation = (ends[1] - ends[0]) / (2.0 * 1.96);
      scene.identify.bounds.push_back({problem.unknowns[u].name, problem.unknowns[u].value - inside * deviation, INFINITY});
    }
    const auto found = study::run_trials(problems::trial_data(scene, problem), {.trials = trials});
    double in[2] = {0.0, 0.0}, all[2] = {0.0, 0.0};
    for (const study::Trial& trial : found) {
      for (std::size_t u = 0; u < problem.unknowns.size(); ++u) {
        if (trial.status != ident::Status::ok || !trial.ci95[u]) continue;
        const std::size_t kind = u % 3 == 0 ? 0 : 1;
        const double truth = problem.unknowns[u].value, slack = 1e-9 * std::abs(truth);
        in[kind] += (*trial.ci95[u])[0] <= truth + slack && truth - slack <= (*trial.ci95[u])[1];
        all[kind] += 1.0;
      }
    }
    for (const std::size_t kind : {std::size_t{0}, std::size_t{1}}) {
      const std::string row =
          fmt::format("truth {} sd from the bound, {}", inside, kind == 0 ? "bounded unknowns" : "the others");
      fmt::print("{}: coverage {:.3f} of {:.0f}\n", row, in[kind] / all[kind], all[kind]);
      promises.at_least(row + ": coverage", in[kind] / all[kind], line.quick() ? 0.88 : 0.93);
      promises.at_most(row + ": coverage", in[kind] / all[kind], line.quick() ? 1.0 : 0.98);
    }
  }
}

void measure(const bench::CommandLine& line, bench::Promises& promises) {
  measure_times(line, promises);
  measure_active_sets(line, promises);
  measure_cover(line, promises);
}

}  // namespace

int main(int argc, char** argv) { return bench::run(argc, argv, "[SEEDS]", measure); }
