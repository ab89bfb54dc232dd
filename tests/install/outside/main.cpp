#include <cstdlib>
#include <iostream>

#include "ident/identify.hpp"
#include "ident/scene/read_scene.hpp"
#include "problems/problem.hpp"

using namespace jointid;

/// Solves a built-in problem without noise: the unknowns must come out as they went in.
int main() {
  const auto problem = problems::make("A1");
  const auto scene = ident::parse_scene(problem.scene, "A1.toml");
  const auto plan = ident::make_plan(scene, problem.substructures, {problem.assembly});
  const auto solution = ident::solve(*plan);
  std::cout << ident::name(solution.status) << ", rms relative error of K "
            << solution.quality.at(restrictions::Kind::stiffness).rms_relative_error << '\n';
  const bool exact = solution.quality.at(restrictions::Kind::stiffness).rms_relative_error < 1e-6;
  return solution.status == ident::Status::ok && exact ? EXIT_SUCCESS : EXIT_FAILURE;
}
