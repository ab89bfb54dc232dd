// The thesis's friction oscillations: 100,000 events of the chain of ten masses beside numpy's, a bifurcation sweep on two
// threads, the proper orthogonal fractions of Table 3.1 and of the cantilever at 12 Hz. docs/oscillations.md.
// Promised: the first 34 events are numpy's to 1e-9, at least 100 times as fast; 500 parameters on two threads 1.9 times as fast
// as on one.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "bench/bench.hpp"
#include "oscillation/orbit/return_map.hpp"
#include "oscillation/orbit/sweep.hpp"
#include "oscillation/pod/fraction_error.hpp"
#include "oscillation/system/thesis_systems.hpp"

namespace {

using namespace jointid;
using namespace jointid::oscillation;

Eigen::VectorXd chain_start(const ContactSystem& system) {
  const Eigen::Index n = system.degrees();
  return system.state(0.9 * Eigen::VectorXd::LinSpaced(n, 1.0, static_cast<double>(n)), Eigen::VectorXd::Zero(n));
}

void speed(const bench::CommandLine& line, bench::Promises& promises) {
  const std::size_t count = line.quick() ? 5'000 : 100'000;
  const ContactSystem system = contact_system(BeltChain{});
  StickSlip motion(system, chain_start(system));
  std::vector<double> times;
  motion.on_event = [&](const Event& event) { times.push_back(event.time); };
  const double before = bench::processor_seconds();
  while (times.size() < count) motion.advance(motion.time() + 1000.0);
  const double each = (bench::processor_seconds() - before) / static_cast<double>(times.size());
  fmt::print("chain of 10 masses: {} events in {:.3f} s, {:.2f} us each\n", times.size(),
             each * static_cast<double>(times.size()), 1e6 * each);

  const auto text = bench::peer_output(fmt::format("stick_slip.py 10 {}", line.quick() ? 200 : 1500), promises);
  if (!text) return;
  std::istringstream peer(*text);
  double seconds = 0.0, worst = 0.0;
  std::size_t events = 0;
  peer >> seconds >> events;
  for (std::size_t k = 0; k < 34; ++k) {
    double time = 0.0;
    peer >> time;
    worst = std::max(worst, std::abs(time - times[k]));
  }
  const double ratio = seconds / static_cast<double>(events) / each;
  fmt::print("numpy: {} events, {:.0f} us each; first 34 times differ by {:.1e}; ratio {:.0f}\n", events,
             1e6 * seconds / static_cast<double>(events), worst, ratio);
  promises.at_most("first 34 event times less numpy's", worst, 1e-9);
  promises.speed_at_least("times as fast as numpy", ratio, 100.0);
}

SweepCase chain_at(double velocity) {
  BeltChain chain;
  chain.velocity = velocity;
  SweepCase out{contact_system(chain), {}, {}, 500.0, 300.0, 0.0};
  out.start = chain_start(out.system);
  out.form = Eigen::VectorXd::Unit(out.system.size(), 0);
  return out;
}

void sweeps(const bench::CommandLine& line, bench::Promises& promises) {
  std::vector<double> velocities;
  for (std::size_t k = 0; k < (line.quick() ? 20u : 500u); ++k) velocities.push_back(0.5 - 0.001 * static_cast<double>(k));
  std::vector<SweepPoint> one, two;
  bench::Times alone, both;
  alone.add([&] { one = sweep(velocities, chain_at, {1}); });
  both.add([&] { two = sweep(velocities, chain_at, {2}); });
  const double times = alone.wall[0] / both.wall[0], work = both.processor[0] / alone.processor[0];
  bool same = true;
  for (std::size_t k = 0; k < one.size(); ++k) same = same && one[k].values == two[k].values;
  fmt::print(
      "\nsweep of {} belt speeds: {:.2f} s on one thread, {:.2f} s on two: {:.2f} times; processor time {:.2f} s, {:.2f} times "
      "it on two\n",
      velocities.size(), alone.wall[0], both.wall[0], times, alone.processor[0], work);
  promises.holds("a sweep is the same on two threads", same);
  std::array<double, 2> workers{};  // each parameter goes to the worker that is free first
  for (const double velocity : velocities) {
    const double before = bench::processor_seconds();
    sweep({velocity}, chain_at, {1});
    *std::ranges::min_element(workers) += bench::processor_seconds() - before;
  }
  const double shared = (workers[0] + workers[1]) / std::ranges::max(workers);
  fmt::print("by the processor time of each parameter, shared as the sweep shares them, two threads: {:.3f} times\n", shared);
  promises.speed_at_least("two threads by the processor time of each parameter, times as fast", shared, 1.9);
  promises.speed_at_least("a sweep on two threads, times as fast", times, 1.9);
}

void table_3_1(bench::Promises& promises) {
  const ContactSystem system = contact_system(BeltChain{});
  std::vector<double> times;
  for (int i = 0; i < 30'000; ++i) times.push_back(1500.0 + 0.2 * i);
  const oscillation::Samples samples = integrate(system, chain_start(system), 7500.0, times).samples.topRows(10).transpose();
  const oscillation::Fractions found = oscillation::square_fractions(samples);
  constexpr std::array thesis = {94.05, 96.50, 98.53, 99.59, 99.90, 99.95, 99.99};
  constexpr std::array sheet = {92.2, 94.9, 97.4, 99.62, 99.94, 99.97, 99.99};
  fmt::print("\nTable 3.1, sum of sigma^2, %\n{:<4}{:>10}{:>18}\n", "m", "thesis", "ours");
  for (Eigen::Index m = 3; m <= 9; ++m) {
    const auto k = static_cast<std::size_t>(m - 3);
    fmt::print("{:<4}{:>10.2f}{:>11.2f} ± {:.2f}\n", m, thesis[k], 100.0 * found.value(m - 1), 100.0 * found.error(m - 1));
    promises.at_most(
        fmt::format("fraction of {} modes less that of the sheet, in four of their errors", m),
        std::abs(100.0 * found.value(m - 1) - sheet[k]) / std::max(0.05, 4.0 * std::hypot(100.0 * found.error(m - 1), 0.8)), 1.0);
  }
}

void cantilever(bench::Promises& promises) {
  Cantilever beam;
  beam.damping = one_per_cent(beam);
  const ContactSystem system = contact_system(beam);
  const double cycle = 1.0 / beam.frequency_hz;
  std::vector<double> times;
  for (int i = 0; i < 9600; ++i) times.push_back(500.0 * cycle + cycle * i / 96.0);
  const Eigen::VectorXd rest = system.state(Eigen::VectorXd::Zero(6), Eigen::VectorXd::Zero(6));
  const Motion motion = integrate(system, rest, 600.0 * cycle, times);
  Eigen::MatrixXd points(6, 6);
  for (Eigen::Index i = 0; i < 6; ++i) points.row(i) = displacement_row(beam, 0.05 * static_cast<double>(i + 1));
  const oscillation::Pod found = oscillation::pod(oscillation::Samples((points * motion.samples.topRows(6)).transpose()));
  const Eigen::VectorXd share = found.values / found.values.sum();
  fmt::print(
      "\ncantilever, 12 Hz, 2.3 mm, last 100 of 600 cycles: shares of the first modes {:.4f}, {:.4f}, {:.6f} (thesis .9913, "
      ".0083, .0003)\n",
      share(0), share(1), share(2));
  promises.at_most("first share less 0.9956 of the steady motion", std::abs(share(0) - 0.995625600581004), 5e-5);
  BeltChain one{1, 1.0, 1.0, 0.0, 0.2, {0.3, 0.5, std::nullopt, 3.0, 0.0, std::nullopt}};
  const ContactSystem mass = contact_system(one);
  const Motion sawtooth = integrate(mass, mass.state(Eigen::VectorXd::Zero(1), Eigen::VectorXd::Constant(1, 0.2)), 40.0);
  const double period = sawtooth.events[3].time - sawtooth.events[1].time, delta = 0.6;
  const double exact = 2.0 * (std::numbers::pi - std::atan(delta / 0.2)) + 2.0 * delta / 0.2;
  fmt::print("one mass on a belt: period less its closed form {:.1e}\n", period - exact);
  promises.at_most("one mass on a belt: period less its closed form", std::abs(period - exact), 1e-13);
}

void exponents(bench::Promises& promises) {
  fmt::print("\nexponents by the model, nats per unit of time, ± standard errors\n");
  const auto print = [](const char* what, const Exponents& found) {
    fmt::print("{:<44}", what);
    for (std::size_t k = 0; k < found.exponent.size(); ++k)
      fmt::print("{:>9.4f} ± {:.4f}", found.exponent[k], found.standard_error[k]);
    fmt::print("\n");
  };
  const ContactSystem chain = contact_system(BeltChain{});
  const Exponents ten = lyapunov_exponents(chain, chain_start(chain), {4, 1500.0, 6000.0, 2.0});
  print("chain of 10, c = 0.01", ten);
  promises.at_least("largest exponent of the chain, less four errors", ten.exponent[0] - 4.0 * ten.standard_error[0], 0.005);
  BeltChain few{3, 1.0, 1.0, 0.005, 0.2, {0.3, 0.5, 1.0, 3.0, 0.0, std::nullopt}};
  const ContactSystem three = contact_system(few);
  print("chain of 3, c = 0.005, alpha = 1", lyapunov_exponents(three, chain_start(three), {4, 1500.0, 6000.0, 2.0}));
  Cantilever beam;
  beam.damping = one_per_cent(beam);
  beam.frequency_hz = 10.0;
  const ContactSystem system = contact_system(beam);
  const Eigen::VectorXd rest = system.state(Eigen::VectorXd::Zero(6), Eigen::VectorXd::Zero(6));
  print("cantilever, 10 Hz, 2.3 mm (per s)", lyapunov_exponents(system, rest, {2, 10.0, 100.0, 0.1}));
}

void measure_all(const bench::CommandLine& line, bench::Promises& promises) {
  speed(line, promises);
  sweeps(line, promises);
  table_3_1(promises);
  cantilever(promises);
  exponents(promises);
}

}  // namespace

int main(int argc, char** argv) { return bench::run(argc, argv, "", measure_all); }
