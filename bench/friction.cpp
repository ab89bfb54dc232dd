// Friction laws: 100,000 force–tangent evaluations along a random history (corner memory, Masing's rule) beside the accuracy of
// the closed forms; the cost of the finite-element joint and its error against Menq's bar. Promised: a closed-form law needs at
// most 20 ms and agrees with its quadrature to 1e-12; the errors of sliders and of the finite-element joint are those of the
// tables of docs/friction.md, the latter of second order. The quick run stops at 320 sliders and 80 members.
#include <fmt/core.h>

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "bench/bench.hpp"
#include "friction/curve/equivalent.hpp"
#include "friction/joint/distributed_slip.hpp"
#include "friction/joint/fe_cases.hpp"
#include "friction/law/generalized_slip.hpp"
#include "friction/law/law.hpp"
#include "friction/law/laws.hpp"
#include "friction/law/sliders.hpp"
#include "friction/path/masing_path.hpp"
#include "friction/path/parallel.hpp"
#include "friction/path/ring.hpp"
#include "friction/path/series.hpp"

namespace {

using namespace jointid;
using namespace jointid::friction;

/// Independent uniform displacements: two of three turn the path.
std::vector<double> random_history(double largest) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> any(-largest, largest);
  std::vector<double> history(100'000);
  for (double& u : history) u = any(random);
  return history;
}

struct Figures {
  double time_ms = 0.0;
  std::size_t corners = 0;
  double difference = 0.0;
};

Figures measure(const Element& element, double largest) {
  const std::vector<double> history = random_history(largest);
  Figures figures;
  std::vector<double> times;
  double sum = 0.0;
  for (int repeat = 0; repeat < 5; ++repeat) {
    MasingPath path(element);
    times.push_back(1e3 * bench::seconds([&] {
                      for (const double u : history) {
                        const Response at = path.advance(u);
                        sum += at.force + at.tangent;
                        figures.corners = std::max(figures.corners, path.corners().size());
                      }
                    }));
  }
  figures.time_ms = median(times);
  const double stiffness = element.response(0.0).tangent;
  for (const double part : {0.03, 0.3, 1.0}) {
    const double u = part * largest;
    const double closed = element.equivalent_stiffness(u), quadrature = element.Element::equivalent_stiffness(u);
    figures.difference = std::max(figures.difference, std::abs(closed - quadrature) / stiffness);
  }
  return std::isfinite(sum) ? figures : Figures{.difference = sum};
}

Figures report(const std::string& name, const Element& element, double largest) {
  const Figures figures = measure(element, largest);
  fmt::print("{:<34}{:>10.2f}{:>10}{:>14.1e}\n", name, figures.time_ms, figures.corners, figures.difference);
  return figures;
}

std::shared_ptr<const Element> any(const std::string& law, const std::vector<double>& values) {
  return make_element(law, values);
}

void laws_table(bench::Promises& promises) {
  fmt::print("{:<34}{:>10}{:>10}{:>14}\n", "100,000 evaluations", "ms", "corners", "k_e: closed −");
  fmt::print("{:<34}{:>10}{:>10}{:>14}\n", "", "", "at most", "quadrature");
  const auto ren = any("ren", {3.43e-8, 2.79, 5.82e7}), shoukry = any("shoukry", {11.67, 4.5e6});
  const auto closed_form = [&promises](const std::string& name, const Element& element) {
    const Figures figures = report(name, element, 1e-6);
    promises.speed_at_most(name + ": ms of 100,000 evaluations", figures.time_ms, 20.0);
    promises.at_most(name + ": closed form less quadrature", figures.difference, 1e-12);
  };
  closed_form("Ren", *ren);
  closed_form("Shoukry", *shoukry);
  closed_form("Burdekin", *any("burdekin", {5.6e7, -8.09e13}));
  closed_form("bilinear", *any("bilinear", {2e-7, 5e7}));
  closed_form("Iwan", *any("iwan", {10.0, 5e7, -0.5, 0.3}));
  report("u(h) of 11 points",
         GeneralizedSlip(5e7,
                         [] {
                           std::vector<SlipPoint> table;
                           for (int i = 0; i <= 10; ++i) table.push_back({0.1 * i, 3e-8 * std::exp(0.28 * i)});
                           return table;
                         }()),
         1e-6);
  report("Ren and spring in parallel", Parallel({ren, any("spring", {1e6})}), 1e-6);
  report("Ren and Shoukry in series", Series({ren, shoukry}), 1e-6);
  report("ring of Ren", Ring(any("ren", {1.04e-8, 4.856, 9.49e11}), 0.0255, 0.038), 4e-5);
}

void finite_elements_table(bool quick, bench::Promises& promises) {
  fmt::print("\n{:<34}{:>10}{:>14}{:>14}\n", "Menq's bar, 60 load steps", "ms", "iterations", "error");
  MenqBar::Values values = case_one();
  values.length = 0.2;
  const MenqBar bar(values);
  const double last = bar.kinks().back();
  double before = 0.0;
  for (std::size_t members = 5; members <= (quick ? 80u : 640u); members *= 2) {
    MasingPath path(bar);
    FiniteElementJoint joint(menq_mesh(values, members));
    double worst = 0.0, time = 0.0;
    int iterations = 0;
    for (int i = 1; i <= 60; ++i) {
      const double u = last * (i <= 30 ? 0.04 * i : 3.6 - 0.08 * i);
      EquilibriumStep step;
      time += 1e3 * bench::seconds([&] { step = joint.move_to(u); });
      iterations += step.iterations;
      worst = std::max(worst, std::abs(step.force - path.advance(u).force) / bar.limit());
    }
    const std::string order = before > 0.0 ? fmt::format("   order {:.2f}", std::log2(before / worst)) : "";
    fmt::print("{:<34}{:>10.2f}{:>14}{:>14.2e}{}\n", fmt::format("{} members", members), time, iterations, worst, order);
    if (members >= 40)
      promises.at_least(fmt::format("order of the error at {} members", members), std::log2(before / worst), 1.98);
    if (members == 80) promises.at_most("error of 80 members, of the limit", worst, 2.0e-4);
    if (members == 640) promises.at_most("error of 640 members, of the limit", worst, 3.2e-6);
    before = worst;
  }
}

/// Algorithm A against algorithm B along one history, and the loss of an Iwan model at 1 % of its slip amplitude by sliders.
void sliders_table(bool quick, bench::Promises& promises) {
  const auto ren = any("ren", {5e-8, 3.0, 1e6});
  const auto iwan = any("iwan", {1000.0, 1e7, -0.5, 0.5});
  const double slip = iwan->kinks().front(), small = 0.01 * slip;
  fmt::print("\n{:<34}{:>18}{:>22}{:>22}\n", "sliders", "Ren: A − B", "Iwan at 1 %: even", "placed by slip_knots");
  for (const std::size_t count : {10U, 32U, 100U, 320U, 1000U}) {
    if (quick && count > 320) break;
    DistributedSlip state(sliders(*ren, slip_knots(*ren, count, 1e-6)));
    MasingPath path(*ren);
    double worst = 0.0;
    for (const double u : {3e-7, -2e-7, 2.3e-7, 1e-7, 2.9e-7, -6e-7, 5e-7, 4e-7}) {
      worst = std::max(worst, std::abs(state.advance(u).force - path.advance(u).force) / ren->limit());
    }
    std::vector<double> even;
    for (std::size_t i = 1; i <= count; ++i) even.push_back(slip * static_cast<double>(i) / static_cast<double>(count));
    const auto error = [&](const std::vector<double>& knots) {
      return bilinear_assembly(sliders(*iwan, knots))->cycle_energy(small) / iwan->cycle_energy(small) - 1.0;
    };
    const double placed = error(slip_knots(*iwan, count, slip));
    fmt::print("{:<34}{:>18.1e}{:>20.2g} %{:>20.2g} %\n", count, worst, 100.0 * error(even), 100.0 * placed);
    if (count == 320) promises.at_most("force of 320 sliders less the exact one, of the limit", worst, 5.7e-6);
    if (count == 320) promises.at_most("loss of 320 sliders, relative error", std::abs(placed), 0.006);
    if (count == 1000) promises.at_most("force of 1000 sliders less the exact one, of the limit", worst, 7.6e-7);
    if (count == 1000) promises.at_most("loss of 1000 sliders, relative error", std::abs(placed), 5e-4);
  }
}

/// Displacements of cases Two and Three at shares of their limits.
void cases_table(bench::Promises& promises) {
  fmt::print("\n{:<34}{:>8}{:>8}{:>8}{:>8}{:>8}\n", "u of the loaded end, 1e-6 m, at", "0.2", "0.4", "0.6", "0.8", "0.95");
  const auto row = [&promises](const std::string& name, const JointMesh& mesh, double expected) {
    FiniteElementJoint probe(mesh), joint(mesh);
    const double limit = probe.move_to(1.0).force;
    fmt::print("{:<34}", fmt::format("{}, limit {:.1f} N", name, limit));
    for (const double part : {0.2, 0.4, 0.6, 0.8, 0.95}) fmt::print("{:>8.3f}", 1e6 * joint.load_to(part * limit).displacement);
    fmt::print("\n");
    promises.at_most(name + ": limit less that of the table, N", std::abs(limit - expected), 0.05);
  };
  row("case Two", case_two(), 3864.8);
  for (const auto& [name, length, limit] : {std::tuple{"Three A", 1.0, 6361.8}, {"Three B", 0.1, 636.2}}) {
    row(fmt::format("{} Ren", name), case_three(CaseThreeLaw::ren, length, 400), limit);
    row(fmt::format("{} same k", name), case_three(CaseThreeLaw::same_stiffness, length, 400), limit);
    row(fmt::format("{} same slip", name), case_three(CaseThreeLaw::same_macroslip, length, 400), limit);
  }
}

void measure_all(const bench::CommandLine& line, bench::Promises& promises) {
  laws_table(promises);
  sliders_table(line.quick(), promises);
  cases_table(promises);
  finite_elements_table(line.quick(), promises);
}

}  // namespace

int main(int argc, char** argv) { return bench::run(argc, argv, "", measure_all); }
