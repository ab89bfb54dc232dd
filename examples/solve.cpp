// Identifies the joint between two structures from FRFs in memory.
#include <cmath>
#include <cstdlib>
#include <iostream>

#include "ident/identify.hpp"
#include "ident/scene/read_scene.hpp"
#include "two_structures.hpp"

using namespace jointid;

int main() {
  const ident::Scene scene = ident::parse_scene(examples::scene, "in memory");
  const auto plan = ident::make_plan(scene, {examples::structure_1(), examples::structure_2()}, {examples::assembly()});

  ident::Control control;
  control.progress = [](const char* stage, std::size_t done, std::size_t total) {
    std::clog << stage << ' ' << done << '/' << total << '\n';
  };
  control.interrupted = [] { return false; };  // a way to stop
  const ident::Solution solution = ident::solve(*plan, control);

  std::cout << "status " << ident::name(solution.status) << '\n';
  for (const ident::Estimate& unknown : solution.unknowns)
    std::cout << unknown.name << " = " << unknown.value << ' ' << unknown.unit << '\n';
  const bool found = solution.unknowns.size() == 2 &&
                     std::abs(solution.unknowns[0].value - examples::joint.real()) < 1e-6 * examples::joint.real() &&
                     std::abs(solution.unknowns[1].value - examples::joint.imag()) < 1e-4 * examples::joint.imag();
  return ident::is_usable(solution.status) && found ? EXIT_SUCCESS : EXIT_FAILURE;
}
