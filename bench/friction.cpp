// Friction laws: 100,000 force–tangent evaluations along a random history (corner memory, Masing's rule) beside the accuracy of the
// closed forms; the cost of the finite-element joint and its error against Menq's bar. Returns 1 when a closed-form law needs 20 ms
// or more, or differs from its quadrature by more than 1e-12.
//   bench_friction
#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "friction/curve/equivalent.hpp"
#include "friction/joint/distributed_slip.hpp"
#include "friction/joint/fe_cases.hpp"
#include "friction/law/generalized_slip.hpp"
#include "friction/law/laws.hpp"
#include "friction/law/sliders.hpp"
#include "friction/path/masing_path.hpp"
#include "friction/path/parallel.hpp"
#include "friction/path/ring.hpp"
#include "friction/path/series.hpp"
#include "measure.hpp"

namespace {

using namespace jointid;
using namespace jointid::friction;

double milliseconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

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
    const auto start = std::chrono::steady_clock::now();
    for (const double u : history) {
      const Response at = path.advance(u);
      sum += at.force + at.tangent;
      figures.corners = std::max(figures.corners, path.corners().size());
    }
    times.push_back(milliseconds_since(start));
  }
  figures.time_ms = bench::median(times);
  const double stiffness = element.response(0.0).tangent;
  for (const double part : {0.03, 0.3, 1.0}) {
    const double u = part * largest;
    const double closed = element.equivalent_stiffness(u), quadrature = element.Element::equivalent_stiffness(u);
    figures.difference = std::max(figures.difference, std::abs(closed - quadrature) / stiffness);
  }
  return std::isfinite(sum) ? figures : Figures{.difference = sum};
}

bool report(const std::string& name, const Element& element, double largest, bool promised) {
  const Figures figures = measure(element, largest);
  fmt::print("{:<34}{:>10.2f}{:>10}{:>14.1e}\n", name, figures.time_ms, figures.corners, figures.difference);
  return !promised || (figures.time_ms < 20.0 && figures.difference < 1e-12);
}

std::shared_ptr<const Element> any(const std::string& law, const std::vector<double>& values) {
  return make_element(law, values);
}

bool laws_table() {
  fmt::print("{:<34}{:>10}{:>10}{:>14}\n", "100,000 evaluations", "ms", "corners", "k_e: closed −");
  fmt::print("{:<34}{:>10}{:>10}{:>14}\n", "", "", "at most", "quadrature");
  const auto ren = any("ren", {3.43e-8, 2.79, 5.82e7}), shoukry = any("shoukry", {11.67, 4.5e6});
  bool kept = report("Ren", *ren, 1e-6, true);
  kept &= report("Shoukry", *shoukry, 1e-6, true);
  kept &= report("Burdekin", *any("burdekin", {5.6e7, -8.09e13}), 1e-6, true);
  kept &= report("bilinear", *any("bilinear", {2e-7, 5e7}), 1e-6, true);
  kept &= report("Iwan", *any("iwan", {10.0, 5e7, -0.5, 0.3}), 1e-6, true);
  report("u(h) of 11 points", GeneralizedSlip(5e7, [] {
           std::vector<SlipPoint> table;
           for (int i = 0; i <= 10; ++i) table.push_back({0.1 * i, 3e-8 * std::exp(0.28 * i)});
           return table;
         }()), 1e-6, false);
  report("Ren and spring in parallel", Parallel({ren, any("spring", {1e6})}), 1e-6, false);
  report("Ren and Shoukry in series", Series({ren, shoukry}), 1e-6, false);
  report("ring of Ren", Ring(any("ren", {1.04e-8, 4.856, 9.49e11}), 0.0255, 0.038), 4e-5, false);
  return kept;
}

void finite_elements_table() {
  fmt::print("\n{:<34}{:>10}{:>14}{:>14}\n", "Menq's bar, 60 load steps", "ms", "iterations", "error");
  MenqBar::Values values = case_one();
  values.length = 0.2;
  const MenqBar bar(values);
  const double last = bar.kinks().back();
  double before = 0.0;
  for (const std::size_t members : {5, 10, 20, 40, 80, 160, 320, 640}) {
    MasingPath path(bar);
    FiniteElementJoint joint(menq_mesh(values, members));
    double worst = 0.0, time = 0.0;
    int iterations = 0;
    for (int i = 1; i <= 60; ++i) {
      const double u = last * (i <= 30 ? 0.04 * i : 3.6 - 0.08 * i);
      const auto start = std::chrono::steady_clock::now();
      const EquilibriumStep step = joint.move_to(u);
      time += milliseconds_since(start);
      iterations += step.iterations;
      worst = std::max(worst, std::abs(step.force - path.advance(u).force) / bar.limit());
    }
    const std::string order = before > 0.0 ? fmt::format("   order {:.2f}", std::log2(before / worst)) : "";
    fmt::print("{:<34}{:>10.2f}{:>14}{:>14.2e}{}\n", fmt::format("{} members", members), time, iterations, worst, order);
    before = worst;
  }
}

/// Algorithm A against algorithm B along one history, and the loss of an Iwan model at 1 % of its slip amplitude by sliders.
void sliders_table() {
  const auto ren = any("ren", {5e-8, 3.0, 1e6});
  const auto iwan = any("iwan", {1000.0, 1e7, -0.5, 0.5});
  const double slip = iwan->kinks().front(), small = 0.01 * slip;
  fmt::print("\n{:<34}{:>18}{:>22}{:>22}\n", "sliders", "Ren: A − B", "Iwan at 1 %: even", "placed by slip_knots");
  for (const std::size_t count : {10, 32, 100, 320, 1000}) {
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
    fmt::print("{:<34}{:>18.1e}{:>20.2g} %{:>20.2g} %\n", count, worst, 100.0 * error(even),
               100.0 * error(slip_knots(*iwan, count, slip)));
  }
}

/// Displacements of cases Two and Three at shares of their limits.
void cases_table() {
  fmt::print("\n{:<34}{:>8}{:>8}{:>8}{:>8}{:>8}\n", "u of the loaded end, 1e-6 m, at", "0.2", "0.4", "0.6", "0.8", "0.95");
  const auto row = [](const std::string& name, const JointMesh& mesh) {
    FiniteElementJoint probe(mesh), joint(mesh);
    const double limit = probe.move_to(1.0).force;
    fmt::print("{:<34}", fmt::format("{}, limit {:.1f} N", name, limit));
    for (const double part : {0.2, 0.4, 0.6, 0.8, 0.95}) fmt::print("{:>8.3f}", 1e6 * joint.load_to(part * limit).displacement);
    fmt::print("\n");
  };
  row("case Two", case_two());
  for (const auto& [name, length] : {std::pair{"Three A", 1.0}, {"Three B", 0.1}}) {
    row(fmt::format("{} Ren", name), case_three(CaseThreeLaw::ren, length, 400));
    row(fmt::format("{} same k", name), case_three(CaseThreeLaw::same_stiffness, length, 400));
    row(fmt::format("{} same slip", name), case_three(CaseThreeLaw::same_macroslip, length, 400));
  }
}

}  // namespace

int main() {
  const bool kept = laws_table();
  sliders_table();
  cases_table();
  finite_elements_table();
  return kept ? 0 : 1;
}
