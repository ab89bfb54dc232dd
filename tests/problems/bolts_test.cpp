#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/complex.hpp"
#include "ident/identify.hpp"
#include "problems/case/catalogue.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/structure/brick.hpp"
#include "problems/structure/spring_coupling.hpp"

namespace jointid::problems {
namespace {

using frf::Dof;

constexpr Solid steel = {.youngs_modulus = 2.1e11, .poissons_ratio = 0.3, .density = 7800.0};
const Block uneven = {.first_node = 1, .origin = {0.1, -0.2, 0.3}, .size = {0.3, 0.12, 0.2}, .elements = {3, 2, 2}};

/// Values of a linear field u = A x + b at the DOFs of a structure.
std::vector<double> linear_field(const Structure& structure, const Matrix& a, const std::vector<double>& b) {
  std::vector<double> u;
  for (const Dof& dof : structure.dofs()) {
    const auto axis = static_cast<std::size_t>(dof.direction) - 1;
    double value = b[axis];
    for (const frf::Node& node : structure.nodes()) {
      for (std::size_t k = 0; node.id == dof.node && k < 3; ++k) value += a[axis][k] * node.position[k];
    }
    u.push_back(value);
  }
  return u;
}

std::vector<double> times(const std::vector<double>& matrix, const std::vector<double>& u) {
  std::vector<double> out(u.size());
  for (std::size_t i = 0; i < matrix.size(); ++i) out[i / u.size()] += matrix[i] * u[i % u.size()];
  return out;
}

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

const Matrix nothing(3, std::vector<double>(3));

/// Patch test: constant strain gives no force inside, and the energy of the continuum, V (λ (tr ε)² + 2μ ε:ε).
TEST(Brick, ConstantStrainIsExact) {
  const Structure block = solid_block(steel, uneven);
  const Matrix a = {{1e-3, 2e-4, -3e-4}, {5e-4, -4e-4, 1e-4}, {7e-4, 6e-4, 9e-4}};
  const std::vector<double> u = linear_field(block, a, {1e-3, 2e-3, 3e-3});
  const std::vector<double> force = times(block.matrix(Kind::stiffness), u);
  double largest = 0.0;
  for (const double each : force) largest = std::max(largest, std::abs(each));
  for (const std::int64_t node : {uneven.node(1, 1, 1), uneven.node(2, 1, 1)}) {
    for (const char* direction : {":+X", ":+Y", ":+Z"}) {
      EXPECT_NEAR(force[block.index(Dof::parse(std::to_string(node) + direction))], 0.0, 1e-12 * largest);
    }
  }
  const double lambda = 2.1e11 * 0.3 / (1.3 * 0.4), mu = 2.1e11 / 2.6;
  double energy = lambda * std::pow(a[0][0] + a[1][1] + a[2][2], 2);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) energy += 2.0 * mu * std::pow(0.5 * (a[i][j] + a[j][i]), 2);
  }
  energy *= 0.3 * 0.12 * 0.2;
  EXPECT_NEAR(dot(u, force), energy, 1e-12 * energy);
}

/// Translations see the mass, rotations the moment of inertia, which the consistent mass matrix gives exactly.
TEST(Brick, MassAndMomentOfInertiaAreThoseOfTheBlock) {
  const Structure block =
      solid_block(steel, {.first_node = 1, .origin = {-0.15, -0.06, -0.1}, .size = {0.3, 0.12, 0.2}, .elements = {3, 2, 1}});
  const double mass = 7800.0 * 0.3 * 0.12 * 0.2;
  const std::vector<double> along = linear_field(block, nothing, {1.0, 0.0, 0.0});
  EXPECT_NEAR(dot(along, times(block.matrix(Kind::mass), along)), mass, 1e-12 * mass);
  const std::vector<double> about_z = linear_field(block, {{0, -1, 0}, {1, 0, 0}, {0, 0, 0}}, {0, 0, 0});
  const double inertia = mass * (0.3 * 0.3 + 0.12 * 0.12) / 12.0;
  EXPECT_NEAR(dot(about_z, times(block.matrix(Kind::mass), about_z)), inertia, 1e-12 * inertia);
}

TEST(Brick, RigidMotionTakesNoForceInAnyDirection) {
  const Structure block = solid_block(steel, uneven);
  double largest = 0.0;
  for (const double each : block.matrix(Kind::stiffness)) largest = std::max(largest, std::abs(each));
  const Matrix turns[] = {
      nothing, {{0, 0, 0}, {0, 0, -1}, {0, 1, 0}}, {{0, 0, 1}, {0, 0, 0}, {-1, 0, 0}}, {{0, -1, 0}, {1, 0, 0}, {0, 0, 0}}};
  for (const Matrix& turn : turns) {
    for (const double force : times(block.matrix(Kind::stiffness), linear_field(block, turn, {1.0, -2.0, 0.5}))) {
      EXPECT_NEAR(force, 0.0, 1e-12 * largest);
    }
  }
}

const Case& bolts() {
  static const Case definition = [] {
    for (Case& each : cases_of_bolts()) {
      if (each.name == "bolts") return std::move(each);
    }
    return Case{};
  }();
  return definition;
}

const Problem& bolts_problem() {
  static const Problem problem = build(bolts());
  return problem;
}

TEST(Bolts, BlocksAreFreeAndTheJointHasTwelveSprings) {
  const Problem& problem = bolts_problem();
  EXPECT_EQ(problem.joint_dofs.size(), 24u);
  EXPECT_EQ(problem.assembly.header.response.size(), 60u);
  EXPECT_EQ(problem.unknowns.size(), 24u);
  EXPECT_EQ(problem.assembly.header.lines(), 157u);
  const auto rigid = [](const Modes& modes) { return std::count(modes.frequency_hz.begin(), modes.frequency_hz.end(), 0.0); };
  for (const Modes& part : problem.substructure_modes) EXPECT_EQ(rigid(part), 6);
  EXPECT_EQ(rigid(problem.assembly_modes), 6);
}

TEST(Bolts, SeveralModesLieInTheRange) {
  const Problem& problem = bolts_problem();
  const std::vector<double>& axis = problem.assembly.header.frequency_hz;
  const auto inside = [&](const Modes& modes) {
    return std::ranges::count_if(modes.frequency_hz, [&](double f) { return f > axis.front() && f < axis.back(); });
  };
  for (const Modes& part : problem.substructure_modes) EXPECT_GE(inside(part), 4);
  EXPECT_GE(inside(problem.assembly_modes), 10);
}

/// Modes of the parts coupled spring by spring, against the LU decomposition of the whole.
TEST(Bolts, CoupledFrfsAreThoseOfTheAssembledMatrices) {
  const Problem& problem = bolts_problem();
  const frf::FrfSet& coupled = problem.assembly;
  std::vector<double> some;
  const std::vector<std::size_t> lines = {0, 40, 156};
  for (const std::size_t line : lines) some.push_back(coupled.header.frequency_hz[line]);
  const auto expect_equal = [&](const Structure& structure, const frf::FrfSet& found) {
    const std::vector<Dof> columns(found.header.reference.begin(), found.header.reference.begin() + 7);
    const frf::FrfSet direct =
        frequency_response(structure, {.response = found.header.response, .reference = columns, .frequency_hz = some});
    for (std::size_t i = 0; i < lines.size(); ++i) {
      double largest = 0.0;
      for (std::size_t k = 0; k < direct.header.entries(); ++k)
        largest = std::max(largest, std::abs(direct.values[i * direct.header.entries() + k]));
      for (std::size_t r = 0; r < direct.header.response.size(); ++r) {
        for (std::size_t c = 0; c < 7; ++c) {
          EXPECT_LE(std::abs(found.values[found.index(lines[i], r, c)] - direct.values[direct.index(i, r, c)]), 1e-9 * largest);
        }
      }
    }
  };
  expect_equal(bolts().assembly, coupled);
  expect_equal(bolts().substructures[0], problem.substructures[0]);
}

TEST(Bolts, FrfsAreReciprocal) {
  for (const frf::FrfSet* set : {&bolts_problem().substructures[1], &bolts_problem().assembly}) {
    const std::size_t n = set->header.response.size();
    for (std::size_t line = 0; line < set->header.lines(); line += 13) {
      double largest = 0.0, difference = 0.0;
      for (std::size_t r = 0; r < n; ++r) {
        for (std::size_t c = 0; c < n; ++c) {
          largest = std::max(largest, std::abs(set->values[set->index(line, r, c)]));
          difference = std::max(difference, std::abs(set->values[set->index(line, r, c)] - set->values[set->index(line, c, r)]));
        }
      }
      EXPECT_LE(difference, 1e-11 * largest);
    }
  }
}

/// Largest relative error of the springs by the problem's own scene (method one).
std::array<double, 2> spring_errors(const Problem& problem, Measurement data) {
  const ident::Scene scene = problems::scene(problem);
  const auto plan = problems::plan(scene, std::move(data));
  const ident::Solution solution = ident::solve(*plan);
  std::array<double, 2> worst{};
  for (std::size_t i = 0; i < problem.unknowns.size(); ++i) {
    const double error = std::abs(solution.unknowns[i].value / problem.unknowns[i].value - 1.0);
    worst[i / 12] = std::max(worst[i / 12], error);
  }
  return worst;
}

TEST(Bolts, SpringsAreFoundByTheirOwnScene) {
  const Problem& problem = bolts_problem();
  const auto clean = spring_errors(problem, {problem.substructures, problem.assembly});
  EXPECT_LE(clean[0], 1e-7);
  EXPECT_LE(clean[1], 1e-6);
  const auto noisy = spring_errors(problem, polluted(problem, 1, 0));
  EXPECT_LE(noisy[0], 0.02);
  EXPECT_LE(noisy[1], 0.15);
}

}  // namespace
}  // namespace jointid::problems
