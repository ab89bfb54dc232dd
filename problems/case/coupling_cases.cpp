#include "problems/case/coupling_cases.hpp"

namespace jointid::problems {
namespace {

constexpr double loss_factor = 0.01;

/// A spring of k N/m between two coordinates, or to ground from one (second 0).
struct SpringOf {
  int first, second;
  double k;
};

/// Masses m at consecutive coordinates from `first` on, and springs with hysteretic damping.
Structure masses_and_springs(int first, const std::vector<double>& masses, const std::vector<SpringOf>& springs) {
  std::vector<frf::Node> nodes;
  std::vector<frf::Dof> dofs;
  for (std::size_t i = 0; i < masses.size(); ++i) {
    const int number = first + static_cast<int>(i);
    nodes.push_back({.id = number, .position = {0.1 * number, 0.0, 0.0}});
    dofs.push_back(coordinate(number));
  }
  Structure result(std::move(nodes), dofs);
  for (std::size_t i = 0; i < masses.size(); ++i) result.add(Kind::mass, {dofs[i]}, {{masses[i]}});
  for (const SpringOf& spring : springs) {
    restrictions::Spring between{coordinate(spring.first), std::nullopt};
    if (spring.second != 0) between.second = coordinate(spring.second);
    result.add(Kind::stiffness, between, spring.k);
  }
  result.add_proportional_damping(loss_factor);
  return result;
}

CouplingCase case_a() {
  return {.name = "coupling-A",
          .description = "three structures in a ring, 7 DOF, pairs 2-5, 3-6, 4-7, 5 % noise (§5.9.1)",
          .parts = {masses_and_springs(1, {1.0, 1.5, 1.2}, {{1, 0, 2e5}, {1, 2, 1.5e5}, {2, 3, 2.5e5}, {3, 0, 1e5}}),
                    masses_and_springs(4, {0.8, 1.1}, {{4, 5, 1.2e5}, {5, 0, 8e4}}),
                    masses_and_springs(6, {0.9, 1.3}, {{6, 7, 2e5}, {7, 0, 1.4e5}})},
          .join = {{2, 5}, {3, 6}, {4, 7}},
          .ground = {},
          .axis = {.start_hz = 10.0, .step_hz = 0.5, .lines = 341},
          .noise = frf::NoiseModel{},
          .couple = {}};
}

CouplingCase case_b() {
  return {.name = "coupling-B",
          .description = "8 DOF, coordinate 1 grounded, 3 to 7 coupled into one, 5 % noise (§5.9.1)",
          .parts = {masses_and_springs(1, {1.0, 1.2, 0.8}, {{1, 2, 1.5e5}, {2, 3, 2e5}, {3, 0, 5e4}}),
                    masses_and_springs(4, {0.7, 0.9}, {{4, 5, 1e5}, {5, 0, 6e4}}),
                    masses_and_springs(6, {0.6, 1.0, 1.4}, {{6, 7, 1.2e5}, {7, 8, 1.8e5}, {8, 0, 9e4}})},
          .join = {{3, 6}, {3, 4}, {4, 7}, {5, 6}},
          .ground = {1},
          .axis = {.start_hz = 10.0, .step_hz = 0.5, .lines = 241},
          .noise = frf::NoiseModel{},
          .couple = "method = \"pcc\"\n"};
}

CouplingCase case_c() {
  constexpr double k = 1e5, stiff = 1000.0 * k;
  return {.name = "coupling-C",
          .description = "11 DOF, locally rigid, pairs 1-11, 2-10, 3-9, 4-8, 5-7, consistent errors (§5.9.3)",
          .parts = {masses_and_springs(1, {1.0, 1.0, 1.0, 1.0, 1.0}, {{1, 0, k}, {1, 2, stiff}, {2, 3, k}, {3, 4, k}, {4, 5, stiff}}),
                    masses_and_springs(6, {1.0, 1.0, 1.0, 1.0, 1.0, 1.0},
                                       {{6, 0, k}, {6, 7, k}, {7, 8, stiff}, {8, 9, k}, {9, 10, k}, {10, 11, stiff}})},
          .join = {{1, 11}, {2, 10}, {3, 9}, {4, 8}, {5, 7}},
          .ground = {},
          .axis = {.start_hz = 5.0, .step_hz = 0.25, .lines = 381},
          .noise = ConsistentErrors{},
          .couple = "method = \"mtc\"\nthreshold = \"auto\"  # leaves out pairs that the others nearly imply\n"};
}

}  // namespace

std::vector<CouplingCase> all_coupling_cases() { return {case_a(), case_b(), case_c()}; }

}  // namespace jointid::problems
