// An assembly predicted with a joint that was identified from the same parts: cases A1 and B. The parts' FRFs are coupled again
// with the joint that method "likelihood" finds from them and from some FRFs of the assembly. Coverage of the 95 % intervals of
// the coupled FRFs with the joint taken as exact, with its covariance, and with what it has in common with the FRFs that it was
// found from. Promised: docs/coupling.md.
#include <fmt/core.h>

#include <cmath>
#include <memory>
#include <string>

#include "bench/bench.hpp"
#include "coupling/assembly_reader.hpp"
#include "ident/identify.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"
#include "tasks/identified_joint.hpp"

namespace {

using namespace jointid;

struct Figures {
  double inside = 0.0, count = 0.0, squares = 0.0;

  void add(double error, double variance) {
    inside += std::abs(error) <= 1.96 * std::sqrt(variance) ? 1.0 : 0.0;
    squares += error * error / variance;
    count += 1.0;
  }
  double coverage() const { return inside / count; }
  double quotient() const { return squares / count; }  ///< 1 where variances are right
};

std::vector<std::size_t> all(std::size_t count) {
  std::vector<std::size_t> out(count);
  for (std::size_t i = 0; i < count; ++i) out[i] = i;
  return out;
}

/// The coupled FRFs of some lines against the exact assembly.
void compare(const problems::Problem& problem, const frf::FrfHeader& exact, coupling::AssemblyReader& reader, const ident::Plan& plan,
             Figures& to) {
  const frf::FrfHeader& header = reader.header();
  std::vector<std::size_t> lines;
  for (const ident::Line& line : plan.lines) lines.push_back(line.substructures);
  const auto responses = all(header.response.size()), references = all(header.reference.size());
  const frf::Block block{lines, responses, references};
  std::vector<Complex> values(block.size()), variance(block.size());
  reader.read(block, values, variance);
  std::size_t next = 0;
  for (const std::size_t line : lines) {
    for (const std::size_t r : responses) {
      for (const std::size_t c : references) {
        const std::size_t row = frf::find_coordinate(exact.response, header.response[r]),
                          column = frf::find_coordinate(exact.reference, header.reference[c]);
        const std::size_t at = next++;
        if (row == frf::npos || column == frf::npos) continue;
        const double sign = header.response[r].sign * exact.response[row].sign * header.reference[c].sign * exact.reference[column].sign;
        const Complex error = sign * values[at] - problem.assembly.values[problem.assembly.index(line, row, column)];
        to.add(error.real(), variance[at].real());
        to.add(error.imag(), variance[at].imag());
      }
    }
  }
}

struct Ways {
  Figures exact, alone, shared;
};

void add(const problems::Problem& problem, const ident::Scene& scene, std::uint64_t seed, Ways& to) {
  const problems::Measurement data = problems::polluted(problem, seed, 0);
  const auto plan = problems::plan(scene, data);
  ident::Control control;
  control.threads = 1;
  control.detail = ident::Detail::estimates;
  const ident::Solution solution = ident::solve(*plan, control);
  if (!ident::is_usable(solution.status)) return;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < data.substructures.size(); ++i) names.push_back("part" + std::to_string(i));
  const coupling::KnownJoint joint = tasks::identified_joint(*plan, solution, {}, names, true, control);
  for (Figures* figures : {&to.exact, &to.alone, &to.shared}) {
    std::vector<coupling::Part> parts;
    for (std::size_t i = 0; i < data.substructures.size(); ++i) {
      std::vector<std::unique_ptr<frf::FrfSource>> sources;
      sources.push_back(frf::from_memory(data.substructures[i]));
      parts.push_back({names[i], std::make_shared<frf::FrfSystem>(names[i], std::move(sources), frf::Composition::merged, false)});
    }
    coupling::Assembly assembly;
    assembly.joints = {joint};
    if (figures == &to.exact) assembly.joints[0].uncertainty = nullptr;
    if (figures == &to.alone) {
      auto without = std::make_shared<coupling::JointUncertainty>(*joint.uncertainty);
      without->common = nullptr;
      assembly.joints[0].uncertainty = std::move(without);
    }
    coupling::Options options;
    options.uncertainty = true;
    options.threads = 1;
    options.noise = scene.noise->frf_model;
    coupling::AssemblyReader reader(std::move(parts), assembly, options, problem.name);
    compare(problem, problem.assembly.header, reader, *plan, *figures);
  }
}

void print(const char* what, const Figures& of) {
  fmt::print("  {:44} coverage {:.3f}, errors² over variances {:.3f}\n", what, of.coverage(), of.quotient());
}

/// `equations`: of the scene where there are none.
void measure(const std::string& name, double step_hz, std::vector<ident::Equation> equations, std::size_t tests,
             bench::Promises& promises) {
  problems::Problem problem = problems::make(name);
  const frf::NoiseModel noise{.kind = frf::NoiseKind::circular, .level = 0.02, .reciprocal = false};
  problem.noise = noise;
  ident::Scene scene = problems::scene(problem);
  scene.identify.method = ident::Method::likelihood;
  scene.frequency.step_hz = step_hz;
  if (!equations.empty()) scene.identify.equations = std::move(equations);
  scene.noise = ident::NoiseSection{.model = "circular", .level = noise.level, .frf_model = noise};
  Ways ways;
  for (std::uint64_t seed = 1; seed <= tests; ++seed) add(problem, scene, seed, ways);
  fmt::print("{}, 2 % circular noise, {} Hz between lines, {} tests, {} numbers\n", name, step_hz, tests, ways.shared.count);
  print("joint taken as exact", ways.exact);
  print("with its covariance", ways.alone);
  print("and what it shares with the parts' FRFs", ways.shared);
  // The numbers of a test depend on each other; so many tests tell the share to about a hundredth.
  promises.at_least(name + ": coverage of coupled FRFs", ways.shared.coverage(), 0.93);
  promises.at_most(name + ": coverage of coupled FRFs", ways.shared.coverage(), 0.97);
}

void measure_all(const bench::CommandLine& line, bench::Promises& promises) {
  const std::size_t tests = line.count(0, 100, 20);
  measure("A1", 60.0, {}, tests, promises);
  measure("A1", 150.0, {ident::Equation::nn}, tests, promises);
  measure("A1", 300.0, {ident::Equation::nn}, tests, promises);
  measure("B", 60.0, {ident::Equation::nn}, tests, promises);
}

}  // namespace

int main(int argc, char** argv) { return bench::run(argc, argv, "[TESTS]", measure_all); }
