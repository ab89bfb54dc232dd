#pragma once

#include <memory>

#include "ident/identify.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"

namespace jointid::ident {

/// A built-in problem for method "likelihood" with noise of some level.
struct LikelihoodCase {
  explicit LikelihoodCase(const std::string& name, double level = 0.05) : problem(problems::make(name)) {
    auto& noise = std::get<frf::NoiseModel>(problem.noise);
    noise.level = level;
    scene = problems::scene(problem);
    scene.identify.method = Method::likelihood;
    scene.identify.equations = {Equation::nn, Equation::nj};
    scene.noise = NoiseSection{.model = frf::name(noise.kind), .level = level, .frf_model = noise};
  }

  std::unique_ptr<Plan> clean() const { return problems::plan(scene, {problem.substructures, problem.assembly}); }
  std::unique_ptr<Plan> polluted(std::uint64_t seed = 1) const {
    return problems::plan(scene, problems::polluted(problem, seed, 0));
  }

  problems::Problem problem;
  Scene scene;
};

inline bool tells(const Solution& solution, FindingKind kind) {
  for (const Finding& finding : solution.identifiability->findings) {
    if (finding.kind == kind) return true;
  }
  return false;
}

}  // namespace jointid::ident
