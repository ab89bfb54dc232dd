// Predicts the FRFs of two structures that are joined rigidly at masses 2 and 3, from those of the structures.
#include "tasks/couple.hpp"

#include <cmath>
#include <cstdlib>
#include <iostream>

#include "ident/scene/couple_scene.hpp"
#include "two_structures.hpp"

using namespace jointid;

int main() {
  const ident::CoupleScene scene = ident::parse_couple_scene(R"(
    [data]
    parts = ["structure 1", "structure 2"]
    [couple]
    join = [["2:+Z", "3:+Z"]]
  )",
                                                             "in memory");
  ident::Control control;
  control.interrupted = [] { return false; };  // a way to stop
  const tasks::CoupledSets coupled = tasks::couple(scene, {examples::structure_1(), examples::structure_2()}, false, control);

  std::cout << "status " << ident::name(coupled.result.status) << ", resonances at";
  for (const double hz : coupled.result.result.resonances_hz) std::cout << ' ' << hz;
  std::cout << " Hz\n";
  const frf::FrfSet& set = coupled.frfs;
  double worst = 0.0;
  for (std::size_t line = 0; line < set.header.lines(); ++line) {
    const Complex exact = examples::assembled(set.header.frequency_hz[line], 0.0)[0][0];
    worst = std::max(worst, std::abs(set.values[set.index(line, 0, 0)] - exact) / std::abs(exact));
  }
  std::cout << "largest error of 1:+Z / 1:+Z: " << worst << '\n';
  return coupled.result.status == ident::Status::ok && set.header.lines() == 101 && worst < 1e-9 ? EXIT_SUCCESS : EXIT_FAILURE;
}
