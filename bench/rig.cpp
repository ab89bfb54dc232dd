// A rig as laboratories have it: two structures of 30 responses and 15 references each, joined by six springs with damping (12 joint
// coordinates, all instrumented and driven), every FRF measured by itself with circular errors of 1 % and their variances; method
// `likelihood` to the intervals. Prints processor time, phases, memory above what the FRFs themselves take, and what `plan` expected of
// both, at a quarter, a half and all of the lines, the growth exponents, and the clock on one thread and on all. Promised: no estimate is
// more than five standard errors off, memory and processor time within a factor of what `plan` expects. The rig: 3200 lines.
#include <fmt/core.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "bench/bench.hpp"
#include "bench/memory.hpp"
#include "bench/random_structures.hpp"
#include "ident/identify.hpp"
#include "ident/plan/expected_time.hpp"

namespace {

using namespace jointid;

constexpr std::size_t joint_coordinates = 12;

/// The columns of some references, with errors of a level in each FRF for itself.
frf::FrfSet measured(const frf::FrfSet& all, const std::vector<bool>& is_driven, double level, std::mt19937& generator) {
  std::normal_distribution<double> normal;
  frf::FrfSet out;
  out.header.frequency_hz = all.header.frequency_hz;
  out.header.response = all.header.response;
  out.header.noise = frf::NoiseRecord::variance;
  std::vector<std::size_t> columns;
  for (std::size_t c = 0; c < all.header.reference.size(); ++c) {
    if (!is_driven[static_cast<std::size_t>(all.header.reference[c].node)]) continue;
    columns.push_back(c);
    out.header.reference.push_back(all.header.reference[c]);
  }
  for (std::size_t line = 0; line < all.header.lines(); ++line) {
    for (std::size_t r = 0; r < all.header.response.size(); ++r) {
      for (const std::size_t c : columns) {
        const Complex value = all.values[all.index(line, r, c)];
        const double sigma = level * std::abs(value);
        out.values.push_back(value + sigma * Complex(normal(generator), normal(generator)));
        out.variance.emplace_back(sigma * sigma, sigma * sigma);
      }
    }
  }
  return out;
}

struct Rig {
  frf::FrfSet a, b, both;
  bench::SprungSets structure;
};

/// `others` coordinates beside the joint's, of which `driven` are references, too; half of each on either structure.
Rig make_rig(std::size_t lines, std::size_t others, std::size_t driven) {
  Rig rig{{}, {}, {}, bench::sprung_sets(lines, joint_coordinates, others)};
  const std::size_t half = (joint_coordinates + others) / 2, of_joint = joint_coordinates / 2;
  std::vector<bool> is_driven(2 * half);
  for (std::size_t i = 0; i < 2 * half; ++i) is_driven[i] = i % half < of_joint + driven / 2;
  std::mt19937 generator(11);
  rig.a = measured(rig.structure.frfs.a, is_driven, 0.01, generator);
  rig.b = measured(rig.structure.frfs.b, is_driven, 0.01, generator);
  rig.both = measured(rig.structure.frfs.both, is_driven, 0.01, generator);
  rig.structure.frfs = {};
  return rig;
}

struct Run {
  ident::Solution solution;
  double seconds = 0.0, processor_seconds = 0.0, megabytes = 0.0;
  double expected_seconds = 0.0, expected_megabytes = 0.0;
  double largest_error = 0.0;  ///< in standard errors

  double plan_is_off_by() const {
    return std::max(expected_seconds / processor_seconds, processor_seconds / expected_seconds);
  }
};

Run run(std::size_t lines, std::size_t others, std::size_t driven, std::size_t threads) {
  Rig rig = make_rig(lines, others, driven);
  ident::Scene scene;
  restrictions::JointSpec spec;
  spec.dofs = rig.structure.dofs;
  spec.matrices[restrictions::Kind::stiffness] = rig.structure.springs;
  spec.matrices[restrictions::Kind::hysteretic_damping] = rig.structure.springs;
  scene.joints = {spec};
  scene.identify.method = ident::Method::likelihood;
  std::vector<frf::FrfSet> parts, whole;
  parts.push_back(std::move(rig.a));
  parts.push_back(std::move(rig.b));
  whole.push_back(std::move(rig.both));
  const auto plan = ident::make_plan(scene, std::move(parts), std::move(whole));
  ident::Control control;
  control.threads = threads;
  Run out;
  out.expected_seconds = ident::expected_seconds(plan->cost, 1);
  out.expected_megabytes = static_cast<double>(plan->cost.iteration.memory_bytes) / 1e6;
  out.megabytes = bench::growth_megabytes([&] {
    const double before = bench::processor_seconds();
    out.solution = ident::solve(*plan, control);
    out.processor_seconds = bench::processor_seconds() - before;
  });
  out.seconds = out.solution.runtime_s.total;
  for (std::size_t u = 0; u < rig.structure.truth.size(); ++u) {
    const ident::Estimate& estimate = out.solution.unknowns[u];
    const double error = std::abs(estimate.value - rig.structure.truth[u]) / estimate.std_error.value_or(0.0);
    if (!(error <= out.largest_error)) out.largest_error = error;
  }
  return out;
}

std::string phases(const ident::RunTime& time) {
  std::string out;
  for (const auto& [name, phase] : ident::run_time_phases) {
    if (time.*phase >= 0.005 * time.total) out += fmt::format("{}{} {:.0f} %", out.empty() ? "" : ", ", name, 100.0 * time.*phase / time.total);
  }
  return out;
}

void tell(std::size_t lines, const Run& now) {
  fmt::print("{:5} lines  {:7.2f} s of processor time, {:7.2f} by the clock, {} iterations, {:.0f} MB; plan: {:.2f} s, {:.0f} MB\n", lines,
             now.processor_seconds, now.seconds, now.solution.fit.iterations, now.megabytes, now.expected_seconds, now.expected_megabytes);
  fmt::print("             {}; largest error {:.1f} standard errors; {} findings, {}\n", phases(now.solution.runtime_s), now.largest_error,
             now.solution.identifiability ? now.solution.identifiability->findings.size() : 0, ident::name(now.solution.status));
}

void measure(const bench::CommandLine& line, bench::Promises& promises) {
  const std::size_t most = line.count(0, 400, 48), others = line.count(1, 48, 12), driven = line.count(2, 18, 4);
  if (most < 4) throw bench::UsageError("at least 4 lines");
  if (others < driven || others % 2 != 0 || driven % 2 != 0) throw bench::UsageError("coordinates are even, and driven ones among them");
  fmt::print("{} responses x {} references\n", joint_coordinates + others, joint_coordinates + driven);
  Run before;
  for (const std::size_t lines : {most / 4, most / 2, most}) {
    const Run now = run(lines, others, driven, 1);
    tell(lines, now);
    promises.at_most(fmt::format("{} lines, largest error in standard errors", lines), now.largest_error, 5.0);
    if (before.processor_seconds > 0.0) {
      fmt::print("             exponents: time {:.2f}, memory {:.2f}\n", std::log2(now.processor_seconds / before.processor_seconds),
                 std::log2(now.megabytes / before.megabytes));
    }
    before = now;
  }
  const Run shared = run(most, others, driven, 0);
  tell(most, shared);
  fmt::print("             on all threads {:.2f} times as fast by the clock\n", before.seconds / shared.seconds);
  promises.speed_at_most("time over what plan expects, or the reverse", before.plan_is_off_by(), 2.0);
}

}  // namespace

int main(int argc, char** argv) { return bench::run(argc, argv, "[LINES [OTHERS [DRIVEN]]]", measure); }
