#include "problems/solid/solid_blocks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>
#include <utility>

#include "base/complex.hpp"
#include "base/eigen.hpp"
#include "ident/identify.hpp"
#include "ident/plan/models_of_plan.hpp"
#include "ident/scene/read_scene.hpp"
#include "models/matrix_model.hpp"
#include "tests/test_folder.hpp"

namespace jointid::problems {
namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

void append(Triplets& to, const Eigen::SparseMatrix<double>& matrix, int first, double factor = 1.0) {
  for (Eigen::Index j = 0; j < matrix.outerSize(); ++j) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, j); entry; ++entry)
      to.emplace_back(first + static_cast<int>(entry.row()), first + static_cast<int>(j), factor * entry.value());
  }
}

/// Both blocks and the bolts as one structure of 3,465 coordinates, and where its named DOFs are.
struct Whole {
  models::StructureMatrices matrices;
  std::vector<frf::Dof> dofs;
  std::vector<std::size_t> coordinates;
};

Whole whole_of(const SolidBlocks& problem) {
  Whole out;
  Triplets mass, stiffness, damping;
  int first = 0;
  for (const SolidPart& part : problem.parts) {
    append(mass, part.matrices.mass, first);
    append(stiffness, part.matrices.stiffness, first);
    append(damping, part.matrices.stiffness, first, part.matrices.loss_factor);
    for (std::size_t i = 0; i < part.dofs.size(); ++i) {
      out.dofs.push_back(part.dofs[i]);
      out.coordinates.push_back(static_cast<std::size_t>(first) + part.coordinates[i]);
    }
    first += static_cast<int>(part.matrices.mass.rows());
  }
  for (const SolidSpring& spring : problem.springs) {
    const auto row = [&](const frf::Dof& dof) { return static_cast<int>(out.coordinates[frf::find_coordinate(out.dofs, dof)]); };
    const int a = row(spring.first), b = row(spring.second);
    for (const auto& [i, j, sign] : {std::tuple(a, a, 1.0), {b, b, 1.0}, {a, b, -1.0}, {b, a, -1.0}}) {
      stiffness.emplace_back(i, j, sign * spring.stiffness);
      damping.emplace_back(i, j, sign * spring.stiffness * spring.loss);
    }
  }
  for (auto [to, from] : {std::pair(&out.matrices.mass, &mass), std::pair(&out.matrices.stiffness, &stiffness),
                          std::pair(&out.matrices.hysteretic_damping, &damping)}) {
    to->resize(first, first);
    to->setFromTriplets(from->begin(), from->end());
  }
  return out;
}

/// The assembly is made of reduced parts and the bolts' dynamic stiffness; here all is factorised as one.
TEST(SolidBlocks, TheAssemblyIsThatOfAllMatrices) {
  const SolidBlocks problem = make_solid_blocks();
  const Whole whole = whole_of(problem);
  EXPECT_EQ(whole.matrices.mass.rows(), 1575 + 1890);
  models::MatrixModel model(whole.matrices, models::MatrixModel::Factors::sparse);
  const frf::FrfSet& set = problem.assembly;
  ASSERT_EQ(set.header.lines(), 73U);
  std::vector<std::size_t> references;
  for (const frf::Dof& dof : set.header.reference) references.push_back(whole.coordinates[frf::find_coordinate(whole.dofs, dof)]);
  ASSERT_EQ(set.header.response, whole.dofs);
  for (const std::size_t line : {0U, 36U, 72U}) {
    const auto expected = model.receptance(angular(set.header.frequency_hz[line]), whole.coordinates, references);
    ASSERT_TRUE(expected);
    double worst = 0.0;
    for (std::size_t i = 0; i < whole.dofs.size(); ++i) {
      for (std::size_t j = 0; j < references.size(); ++j)
        worst = std::max(worst, std::abs(set.values[set.index(line, i, j)] - (*expected)(at(i), at(j))));
    }
    EXPECT_LE(worst, 1e-9 * expected->cwiseAbs().maxCoeff()) << set.header.frequency_hz[line];
  }
}

TEST(SolidBlocks, TheBoltsAreFoundBetweenTheModels) {
  const TestFolder folder;
  const SolidBlocks problem = make_solid_blocks();
  const auto plan = ident::make_plan(ident::read_scene(write(problem, folder / "", {})));
  const ident::Solution found = ident::solve(*plan);
  EXPECT_EQ(found.status, ident::Status::ok) << found.message;
  ASSERT_EQ(found.unknowns.size(), 2 * problem.springs.size());
  double squares = 0.0;
  for (std::size_t u = 0; u < found.unknowns.size(); ++u) {
    const SolidSpring& spring = problem.springs[u % problem.springs.size()];
    const double truth = spring.stiffness * (u < problem.springs.size() ? 1.0 : spring.loss);
    ASSERT_TRUE(found.unknowns[u].std_error);
    squares += std::pow((found.unknowns[u].value - truth) / *found.unknowns[u].std_error, 2);
    EXPECT_NEAR(found.unknowns[u].value, truth, 4.5 * *found.unknowns[u].std_error) << found.unknowns[u].name;
    EXPECT_LT(*found.unknowns[u].std_error, 1e-2 * truth) << found.unknowns[u].name;
  }
  EXPECT_GT(squares, 8.0) << "24 squares of standard numbers";
  EXPECT_LT(squares, 52.0);
  ASSERT_EQ(found.models.size(), 2u);
  for (const ident::UsedModel& each : found.models) {
    EXPECT_EQ(each.use.way, models::ModelWay::reduced) << each.file;
    EXPECT_GE(each.use.reduced_lines + each.use.factorizations, 73u) << "the first few lines are factorised";
    EXPECT_EQ(each.use.bound, models::Reduction::bound);
    EXPECT_LE(each.use.error, models::Reduction::accepted);
    EXPECT_GT(each.use.vectors, 0u);
  }
}

/// Before a line is read: what both blocks will take.
TEST(SolidBlocks, ThePlanStatesWhatModelsTake) {
  const TestFolder folder;
  const auto plan = ident::make_plan(ident::read_scene(write(make_solid_blocks(), folder / "", {})));
  const std::vector<ident::UsedModel> models = ident::used_models(*plan);
  ASSERT_EQ(models.size(), 2u);
  EXPECT_EQ(models[1].use.coordinates, 1890u);
  EXPECT_EQ(models[1].use.expected_vectors, 8u * 15u) << "of the 15 DOFs that the file names";
  EXPECT_EQ(models[1].use.reduced_lines, 0u);
}

}  // namespace
}  // namespace jointid::problems
