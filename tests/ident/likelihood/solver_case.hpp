#pragma once

#include <variant>

#include "ident/identify.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"

namespace jointid::ident {

/// A built-in problem with uniform errors of a given level, to be identified by the likelihood from the equations nn and nj.
struct SolverCase {
  problems::Problem problem;
  Scene scene;

  SolverCase(const std::string& name, double level) : problem(problems::make(name)), scene(problems::scene(problem)) {
    auto& noise = std::get<frf::NoiseModel>(problem.noise);
    noise.level = level;
    scene.identify.method = Method::likelihood;
    scene.identify.equations = {Equation::nn, Equation::nj};
    scene.noise = NoiseSection{.model = frf::name(noise.kind), .level = level, .frf_model = noise};
  }

  std::vector<double> truth() const {
    std::vector<double> values;
    for (const problems::ExactUnknown& unknown : problem.unknowns) values.push_back(unknown.value);
    return values;
  }

  /// Trial 0 of a seed. `recorded`: the files carry the variances of the exact FRFs, p²/3 of either part squared; else they follow
  /// from the law at values near.
  std::unique_ptr<Plan> plan(const std::string& solver, std::uint64_t seed, bool recorded) const {
    problems::Measurement data = problems::polluted(problem, seed, 0);
    Scene chosen = scene;
    chosen.identify.solver = parse_solver(solver);
    if (recorded) {
      for (std::size_t i = 0; i < data.substructures.size(); ++i) record(problem.substructures[i], data.substructures[i]);
      record(problem.assembly, data.assembly);
      chosen.identify.variance = VarianceChoice::file;
    }
    return problems::plan(chosen, std::move(data));
  }

  Solution solve(const std::string& solver, std::uint64_t seed, bool recorded) const {
    return ident::solve(*plan(solver, seed, recorded), {.threads = 1, .progress = {}, .interrupted = {}, .detail = Detail::estimates});
  }

 private:
  void record(const frf::FrfSet& exact, frf::FrfSet& noisy) const {
    const double share = scene.noise->level * scene.noise->level / 3.0;
    noisy.header.noise = frf::NoiseRecord::variance;
    noisy.coherence.clear();
    noisy.variance.clear();
    for (const Complex& value : exact.values) {
      noisy.variance.emplace_back(share * value.real() * value.real(), share * value.imag() * value.imag());
    }
  }
};

/// The largest difference of two solutions' unknowns in standard errors of the first.
inline double distance(const Solution& one, const Solution& other) {
  double largest = 0.0;
  for (std::size_t i = 0; i < one.unknowns.size(); ++i) {
    largest = std::max(largest, std::abs(one.unknowns[i].value - other.unknowns[i].value) / *one.unknowns[i].std_error);
  }
  return largest;
}

}  // namespace jointid::ident
