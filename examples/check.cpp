// Looks for mistakes in FRFs in memory: the sensor of mass 4 on the assembly pointed the other way.
#include <cstdlib>
#include <iostream>

#include "ident/scene/read_scene.hpp"
#include "ident/whole_check.hpp"
#include "two_structures.hpp"

using namespace jointid;

int main() {
  frf::FrfSet assembly = examples::assembly();
  const std::size_t wrong = 3;
  for (std::size_t line = 0; line < assembly.header.lines(); ++line) {
    for (std::size_t c = 0; c < assembly.header.reference.size(); ++c) assembly.values[assembly.index(line, wrong, c)] *= -1.0;
  }

  const ident::Scene scene = ident::parse_scene(examples::scene, "in memory");
  const std::vector<frf::FrfSet> structures = {examples::structure_1(), examples::structure_2()};
  const ident::CheckResult of_right = ident::check_whole(scene, structures, {examples::assembly()});
  const ident::CheckResult of_wrong = ident::check_whole(scene, structures, {assembly});

  std::cout << "as it is: " << ident::name(of_right.verdict) << "\nwith a sign: " << ident::name(of_wrong.verdict) << '\n';
  for (const ident::Suspect& suspect : of_wrong.suspects) std::cout << ident::title(suspect) << ": " << suspect.evidence << '\n';
  const bool found = !of_wrong.suspects.empty() && of_wrong.suspects.front().kind == ident::SuspectKind::sign;
  return of_right.verdict == ident::Verdict::clean && found ? EXIT_SUCCESS : EXIT_FAILURE;
}
