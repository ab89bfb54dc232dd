// Whether the 95 % intervals of method "likelihood" hold where the data have errors that variances do not tell: a gain of all FRFs of the
// assembly, noise of the force's signal that coherences alone tell of, parts at another temperature than the assembly, and sensors off
// their places. Coverage over seeds, mean width over that of exact calibration, χ² over degrees of freedom, and statuses. Promised:
// docs/likelihood.md.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "base/statistics.hpp"
#include "bench/bench.hpp"
#include "ident/identify.hpp"
#include "problems/case/catalogue.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"
#include "problems/structure/beam.hpp"

namespace {

using namespace jointid;
using problems::Measurement;

/// A kind of measurement of a problem: data of a seed.
struct Situation {
  std::string name;
  problems::Problem problem;
  ident::Scene scene;
  std::function<Measurement(std::uint64_t seed)> data;
};

ident::Scene likelihood_scene(const problems::Problem& problem) {
  ident::Scene scene = problems::scene(problem);
  scene.identify.method = ident::Method::likelihood;
  scene.identify.automatic = false;
  scene.identify.solver = ident::Solver::automatic;
  if (problem.name == "rig1") scene.frequency.step_hz = 12.0;
  const auto& noise = std::get<frf::NoiseModel>(problem.noise);
  if (noise.kind != frf::NoiseKind::hammer) {
    scene.noise = ident::NoiseSection{.model = frf::name(noise.kind), .level = noise.level, .frf_model = noise};
  }
  return scene;
}

/// Two steel beams and a lap joint of three bolts: springs with a loss factor, hammer test.
problems::Case lap() {
  using namespace problems;
  constexpr BeamSection steel = {.width = 0.04, .thickness = 0.008, .youngs_modulus = 2.07e11, .density = 7850.0};
  constexpr std::array<double, 3> bolts = {6e6, 9e6, 5e6};
  constexpr double loss = 0.03;
  const auto dofs = [](const std::vector<std::int64_t>& nodes) {
    std::vector<frf::Dof> out;
    for (const std::int64_t node : nodes) out.push_back({.node = node, .direction = frf::Direction::y});
    return out;
  };
  Case out;
  out.name = "lap";
  out.substructures = {beam(steel, {.first_node = 1, .x = {0.0, 0.1, 0.2, 0.3, 0.37, 0.44, 0.47, 0.5}}),
                       beam(steel, {.first_node = 101, .x = {0.44, 0.47, 0.5, 0.6, 0.72, 0.84, 0.96}})};
  for (Structure& part : out.substructures) part.add_proportional_damping(0.004);
  out.joint_dofs = dofs({6, 7, 8, 101, 102, 103});
  std::vector<restrictions::Spring> pairs;
  std::vector<double> stiffness, damping;
  for (std::size_t b = 0; b < bolts.size(); ++b) {
    pairs.push_back({out.joint_dofs[b], out.joint_dofs[b + bolts.size()]});
    stiffness.push_back(bolts[b]);
    damping.push_back(loss * bolts[b]);
  }
  out.joint = {springs(Kind::stiffness, out.joint_dofs, pairs, stiffness),
               springs(Kind::hysteretic_damping, out.joint_dofs, pairs, damping)};
  out.assembly = assembled(out.substructures, out.joint_dofs, out.joint);
  out.measured_substructures = dofs({1, 2, 3, 4, 6, 7, 8, 101, 102, 103, 104, 105, 106, 107});
  out.measured_assembly = out.measured_substructures;
  out.axis = {.start_hz = 20.0, .step_hz = 16.0, .lines = 74};
  out.noise = frf::NoiseModel{.kind = frf::NoiseKind::hammer, .averages = 5};
  out.hammer = HammerCoherence{};
  out.quantity = frf::Quantity::accelerance;
  return out;
}

problems::Case definition_of(const std::string& name) {
  if (name == "lap") return lap();
  const std::vector<problems::Case> all = problems::all_cases();
  return *std::ranges::find(all, name, &problems::Case::name);
}

/// A problem whose noise, where it is no hammer test, has this level.
problems::Problem noisy(const problems::Case& definition, double level = 0.01) {
  problems::Problem out = problems::build(definition);
  auto& noise = std::get<frf::NoiseModel>(out.noise);
  if (noise.kind != frf::NoiseKind::hammer) noise.level = level;
  return out;
}

Situation clean(const std::string& name, double level) {
  problems::Problem problem = noisy(definition_of(name), level);
  return {fmt::format("{} clean, {:g}", name, level), problem, likelihood_scene(problem),
          [problem](std::uint64_t seed) { return problems::polluted(problem, seed, 0); }};
}

/// All FRFs of the assembly 1 % too large or, every other seed, too small.
Situation gain(const std::string& name, double off) {
  problems::Problem problem = noisy(definition_of(name));
  return {fmt::format("{} gain {:g}", name, off), problem, likelihood_scene(problem), [problem, off](std::uint64_t seed) {
            Measurement out = problems::polluted(problem, seed, 0);
            for (Complex& value : out.assembly.values) value *= seed % 2 == 0 ? 1.0 + off : 1.0 - off;
            return out;
          }};
}

/// Noise of a channel on a hit and line.
Complex noise(const RandomStream& stream, std::uint64_t channel, std::size_t hit, std::size_t line) {
  const auto z = normal_numbers(stream, hit * 4096 + line, channel);
  return Complex(z[0], z[1]) / std::sqrt(2.0);
}

/// H1 of five hits, with coherences: noise of `hammer` times the force on its signal, of 0.2 % of its median FRF on a sensor.
frf::FrfSet hit(const frf::FrfSet& exact, double hammer, const RandomStream& stream) {
  constexpr std::size_t hits = 5;
  constexpr double sensor = 0.002;
  frf::FrfSet out = exact;
  out.variance.clear();
  out.header.noise = frf::NoiseRecord::coherence;
  out.header.averages = hits;
  out.coherence.resize(out.values.size());
  const std::size_t lines = exact.header.lines(), responses = exact.header.response.size(), references = exact.header.reference.size();
  for (std::size_t r = 0; r < responses; ++r) {
    for (std::size_t c = 0; c < references; ++c) {
      std::vector<double> sizes;
      for (std::size_t l = 0; l < lines; ++l) sizes.push_back(std::abs(exact.values[exact.index(l, r, c)]));
      const double floor = sensor * median(std::move(sizes));
      for (std::size_t l = 0; l < lines; ++l) {
        const std::size_t at = exact.index(l, r, c);
        Complex cross = 0.0;
        double force = 0.0, motion = 0.0;
        for (std::size_t h = 0; h < hits; ++h) {
          const Complex f = 1.0 + hammer * noise(stream, c, h, l);
          const Complex x = exact.values[at] + floor * noise(stream, references + c * responses + r, h, l);
          cross += std::conj(f) * x;
          force += std::norm(f);
          motion += std::norm(x);
        }
        out.values[at] = cross / force;
        out.coherence[at] = std::norm(cross) / (force * motion);
      }
    }
  }
  return out;
}

Situation hammer(const std::string& name, double level) {
  problems::Problem problem = noisy(definition_of(name));
  ident::Scene scene = likelihood_scene(problem);
  scene.noise.reset();
  return {fmt::format("{} hammer {:g}", name, level), problem, scene, [problem, level](std::uint64_t seed) {
            Measurement out;
            std::uint64_t set = 0;
            for (const frf::FrfSet& exact : problem.substructures) out.substructures.push_back(hit(exact, level, {seed, 0, set++}));
            out.assembly = hit(problem.assembly, level, {seed, 0, set});
            return out;
          }};
}

problems::Matrix rows_of(const std::vector<double>& values, std::size_t size, double factor) {
  problems::Matrix out(size, std::vector<double>(size));
  for (std::size_t i = 0; i < values.size(); ++i) out[i / size][i % size] = factor * values[i];
  return out;
}

/// The natural frequencies of the parts, or of the last one alone, were this much lower when the assembly was measured.
Situation temperature(const std::string& name, double shift, bool of_one = false) {
  problems::Case definition = definition_of(name);
  for (const problems::Structure& part : definition.substructures) {
    if (of_one && &part != &definition.substructures.back()) continue;
    definition.assembly.add(problems::Kind::stiffness, part.dofs(),
                            rows_of(part.matrix(problems::Kind::stiffness), part.size(), -2.0 * shift));
  }
  problems::Problem problem = noisy(definition);
  return {fmt::format("{} temperature {:g}{}", name, shift, of_one ? " of one part" : ""), problem, likelihood_scene(problem),
          [problem](std::uint64_t seed) { return problems::polluted(problem, seed, 0); }};
}

/// Sensors and hits off their places, drawn anew for every file and seed.
Situation places(const std::string& name, double off) {
  problems::Problem problem = noisy(definition_of(name));
  const ident::Scene scene = likelihood_scene(problem);
  std::get<frf::NoiseModel>(problem.noise).position_errors = off;
  return {fmt::format("{} places {:g} m", name, off), problem, scene,
          [problem](std::uint64_t seed) { return problems::polluted(problem, seed, 0); }};
}

struct Figures {
  std::vector<double> covered;  ///< shares of the seeds
  std::size_t inside = 0, intervals = 0, unknowns = 0, compared = 0, far = 0, ok_and_far = 0;
  double widths = 0.0, chi_square = 0.0, largest_chi_square = 0.0, squares = 0.0, largest_width = 0.0;
  std::map<std::string, std::size_t> statuses;
  std::map<std::string, std::array<std::size_t, 2>> of_unknown;  ///< inside, intervals

  /// Of the unknown that is covered least.
  std::pair<std::string, double> least() const {
    std::pair<std::string, double> out = {"none", 1.0};
    for (const auto& [name, counts] : of_unknown) {
      const double share = static_cast<double>(counts[0]) / static_cast<double>(counts[1]);
      if (share < out.second) out = {name, share};
    }
    return out;
  }

  double coverage() const { return static_cast<double>(inside) / static_cast<double>(std::max<std::size_t>(1, intervals)); }

  /// Standard error: seeds are independent, unknowns of a seed are not.
  double deviation() const {
    double squares = 0.0;
    for (const double share : covered) squares += (share - coverage()) * (share - coverage());
    const auto n = static_cast<double>(covered.size());
    return n > 1.0 ? std::sqrt(squares / (n * (n - 1.0))) : jointid::nan;
  }
};

void add(const problems::Problem& problem, const ident::Solution& found, const ident::Solution* exact, Figures& to) {
  const std::size_t inside = to.inside, intervals = to.intervals;
  ++to.statuses[ident::name(found.status)];
  const double ratio = found.fit.chi_square->value / found.fit.chi_square->degrees_of_freedom;
  to.chi_square += ratio;
  to.largest_chi_square = std::max(to.largest_chi_square, ratio);
  bool far = false;
  for (std::size_t u = 0; u < found.unknowns.size(); ++u) {
    const double truth = problem.unknowns[u].value;
    const ident::Estimate& estimate = found.unknowns[u];
    if (truth == 0.0) continue;
    ++to.unknowns;
    if (!estimate.ci95) continue;
    const auto [low, high] = *estimate.ci95;
    ++to.intervals;
    const bool is_inside = low <= truth && truth <= high;
    to.inside += is_inside;
    auto& [own_inside, own_intervals] = to.of_unknown[estimate.name];
    own_inside += is_inside;
    ++own_intervals;
    const double error = std::abs(estimate.value - truth) / *estimate.std_error;
    to.squares += error * error;
    far = far || error > 3.5;
    if (exact == nullptr || !exact->unknowns[u].std_error) continue;
    const double width = (high - low) / (2.0 * normal_95 * *exact->unknowns[u].std_error);
    to.widths += width;
    ++to.compared;
    to.largest_width = std::max(to.largest_width, width);
  }
  if (to.intervals > intervals)
    to.covered.push_back(static_cast<double>(to.inside - inside) / static_cast<double>(to.intervals - intervals));
  to.far += far;
  to.ok_and_far += far && found.status == ident::Status::ok;
}

/// Widths are compared with exact calibration in the first of them.
constexpr std::uint64_t compared_seeds = 8;

Figures measured(const Situation& situation, std::size_t seeds, bool verbose) {
  Figures out;
  ident::Control control;
  control.threads = 1;
  control.judgement = ident::Judgement::fit;
  ident::Scene exact = situation.scene;
  exact.data.gains = {ident::GainPrior{}};
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const Measurement data = situation.data(seed);
    const ident::Solution found = ident::solve(*problems::plan(situation.scene, data), control);
    std::optional<ident::Solution> without;
    if (seed <= compared_seeds) {
      control.detail = ident::Detail::estimates;
      without = ident::solve(*problems::plan(exact, data), control);
      control.detail = ident::Detail::full;
    }
    add(situation.problem, found, without ? &*without : nullptr, out);
    if (verbose && seed == 1) {
      fmt::print("  {} {}\n", ident::name(found.status), found.message);
      for (const auto& source : found.variances) fmt::print("  {}: {}\n", source.file, source.note);
    }
  }
  const auto n = static_cast<double>(seeds);
  const auto [least, share] = out.least();
  fmt::print("| {} | {} | {:.3f} ± {:.3f} | {} {:.3f} | {:.2f} / {:.2f} | {:.3f} / {:.3f} | {:.2f} | {} |", situation.name, seeds,
             out.coverage(), out.deviation(), least, share, out.widths / static_cast<double>(std::max<std::size_t>(1, out.compared)),
             out.largest_width, out.chi_square / n, out.largest_chi_square,
             std::sqrt(out.squares / static_cast<double>(std::max<std::size_t>(1, out.intervals))), out.ok_and_far);
  for (const auto& [status, count] : out.statuses) fmt::print(" {} {}", count, status);
  fmt::print(" {} of {} |\n", out.intervals, out.unknowns);
  std::fflush(stdout);
  return out;
}

/// Of the frequencies: χ² over degrees of freedom 1.01 to 3 and, last, more.
std::vector<double> shifts_of(const std::string& name) {
  if (name == "A1") return {0.0002, 0.0003, 0.0005, 0.001};
  if (name == "rig1") return {0.0001, 0.0003, 0.001};
  return {0.0003, 0.001, 0.002};
}

void measure(const bench::CommandLine& line, bench::Promises& promises) {
  const std::size_t seeds = line.count(0, 100, 4);
  const std::vector<std::string> kinds =
      line.choice(1, {"clean", "widths", "gain", "hammer", "force", "temperature", "one", "places", "A1", "lap", "rig1"},
                  {"gain", "hammer", "temperature"});
  const auto wanted = [&](const char* kind) { return std::ranges::find(kinds, kind) != kinds.end(); };
  std::vector<std::string> names = {"A1", "lap", "rig1"};
  if (line.quick()) names = {"A1"};
  if (std::ranges::any_of(names, [&](const std::string& name) { return wanted(name.c_str()); })) {
    std::erase_if(names, [&](const std::string& name) { return !wanted(name.c_str()); });
  }
  fmt::print(
      "| situation | seeds | coverage | of the unknown covered least | "
      "width, mean / largest | χ²/f, mean / largest | rms of error / std error | ok beyond 3.5 | "
      "statuses |\n");
  const auto run = [&](const Situation& situation, double least) {
    const Figures found = measured(situation, seeds, true);
    promises.at_least(situation.name + ": coverage", found.coverage(), bench::least_share(least, seeds));
    promises.at_most(situation.name + ": ok with an unknown 3.5 standard errors off", static_cast<double>(found.ok_and_far),
                     0.05 * static_cast<double>(seeds));
  };
  if (wanted("widths")) {
    for (const char* name : {"A1", "B", "C1", "D1", "E1", "F1", "G1", "H4", "rig1"}) {
      for (const double level : {0.01, 0.05}) measured(clean(name, level), seeds, false);
    }
  }
  for (const std::string& name : names) {
    if (wanted("clean")) run(clean(name, 0.01), 0.92);
    if (wanted("gain")) run(gain(name, 0.01), 0.92);
    if (wanted("gain") && !line.quick()) run(gain(name, 0.002), 0.92);
    if (wanted("hammer")) run(hammer(name, 0.02), 0.92);
    if (wanted("force")) run(hammer(name, 0.14), 0.92);
    if (wanted("temperature")) {
      for (const double shift : shifts_of(name)) {
        run(temperature(name, shift), 0.9);
        if (line.quick()) break;
      }
    }
    if ((wanted("one") || wanted("temperature")) && !line.quick()) {
      for (const double shift : shifts_of(name)) {
        const Situation one = temperature(name, shift, true);
        const Figures found = measured(one, seeds, true);
        promises.at_least(one.name + ": coverage", found.coverage(), bench::least_share(0.92, seeds));
      }
    }
    for (const double off : {0.0003, 0.001, 0.003}) {
      if (wanted("places")) measured(places(name, off), seeds, true);
    }
  }
}

}  // namespace

int main(int argc, char** argv) { return bench::run(argc, argv, "[SEEDS [KIND ...]]", measure); }
