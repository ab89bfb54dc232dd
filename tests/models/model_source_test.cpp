#include "models/model_source.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <numeric>

#include "base/error.hpp"
#include "models/matrix_model.hpp"
#include "models/modal_model.hpp"
#include "problems/structure/modes.hpp"
#include "tests/models/model_sample.hpp"

namespace jointid::models {
namespace {

using Indices = std::vector<std::size_t>;

Indices all(std::size_t count) {
  Indices out(count);
  std::iota(out.begin(), out.end(), std::size_t{0});
  return out;
}

/// Largest difference over the largest element.
double difference(const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

Modes modes_of(const problems::Structure& structure) {
  const problems::Modes found = problems::modes(structure);
  Modes out;
  out.normal_shapes = Eigen::Map<const RowMatrixXd>(found.shapes.data(), at(found.dofs.size()), at(found.count()));
  out.complex_shapes.resize(out.normal_shapes.rows(), 0);
  for (std::size_t k = 0; k < found.count(); ++k)
    out.normal.push_back({angular(found.frequency_hz[k]), 1.0, 0.0, found.loss_factor[k]});
  return out;
}

ModelSource source_of(std::unique_ptr<Model> model, const problems::Structure& structure, std::vector<double> frequency_hz,
                      double noise = 0.0) {
  return ModelSource(
      {.file = "model.toml", .model = std::move(model), .coordinates = {structure.dofs(), all(structure.size())}, .noise = noise},
      std::move(frequency_hz));
}

TEST(MatrixModel, HasTheFrfsOfTheStructure) {
  const problems::Structure part = problems::substructure_b();
  const std::vector<double> lines = {10.0, 400.0, 777.0};
  const frf::FrfSet expected = problems::frequency_response(part, {part.dofs(), part.dofs(), lines, 0.0});
  ModelSource source = source_of(std::make_unique<MatrixModel>(matrices_of(part)), part, lines);
  const frf::FrfSet found = frf::load(source);
  double largest = 0.0, worst = 0.0;
  for (std::size_t i = 0; i < found.values.size(); ++i) {
    largest = std::max(largest, std::abs(expected.values[i]));
    worst = std::max(worst, std::abs(found.values[i] - expected.values[i]));
  }
  EXPECT_LE(worst, 1e-12 * largest);
}

TEST(MatrixModel, SparseIsFull) {
  const problems::Structure beam = fine_beam(40);
  StructureMatrices matrices = matrices_of(beam);
  matrices.viscous_damping = 1e-6 * matrices.stiffness;
  MatrixModel full(matrices, MatrixModel::Factors::full), sparse(matrices, MatrixModel::Factors::sparse), chosen(matrices);
  EXPECT_TRUE(chosen.is_sparse());
  EXPECT_FALSE(MatrixModel(matrices_of(problems::substructure_b())).is_sparse());
  const Indices rows = {0, 1, 40, 81}, columns = {80, 2};
  for (const double omega : {30.0, 700.0, 9000.0}) {
    const auto expected = full.receptance(omega, rows, columns), found = sparse.receptance(omega, rows, columns);
    ASSERT_TRUE(expected && found);
    EXPECT_LE(difference(*found, *expected), 1e-8) << omega;  // condition of Z times rounding: 1e7 × 1e-16 and more at low ω
  }
}

TEST(MatrixModel, ALossFactorIsDampingInProportion) {
  const problems::Structure part = problems::substructure_a();
  StructureMatrices with_matrix = matrices_of(part), with_factor = with_matrix;
  with_factor.hysteretic_damping.resize(0, 0);
  with_factor.loss_factor = 0.001;
  const Indices coordinates = all(part.size());
  EXPECT_LE(difference(*MatrixModel(with_factor).receptance(2500.0, coordinates, coordinates),
                       *MatrixModel(with_matrix).receptance(2500.0, coordinates, coordinates)),
            1e-12);
}

TEST(MatrixModel, ComputesTheColumnsThatAreNeeded) {
  const problems::Structure beam = fine_beam(40);
  ModelSource source = source_of(std::make_unique<MatrixModel>(matrices_of(beam)), beam, {100.0, 200.0, 300.0, 400.0});
  const Indices lines = {1, 3}, one = {7}, three = {0, 40, 81};
  std::vector<Complex> rows(6), columns(6);
  source.read({lines, three, one}, rows);
  EXPECT_EQ(source.model_count().factorizations, 2u);
  EXPECT_EQ(source.model_count().columns, 2u);
  source.read({lines, one, three}, columns);  // by symmetry one column is enough
  EXPECT_EQ(source.model_count().factorizations, 4u);
  EXPECT_EQ(source.model_count().columns, 4u);
  for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(rows[i], columns[i]);
}

TEST(MatrixModel, TellsWhereItIsInfinite) {
  const problems::Structure beam = fine_beam(40);
  ModelSource source = source_of(std::make_unique<MatrixModel>(matrices_of(beam)), beam, {0.0, 10.0});
  const Indices at_rest = {0}, moving = {1}, one = {0};
  Complex value;
  source.read({moving, one, one}, {&value, 1});
  try {
    source.read({at_rest, one, one}, {&value, 1});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("model.toml"));
    EXPECT_THAT(error.what(), testing::HasSubstr("free to move has none at 0 Hz"));
  }
  problems::Structure held = fine_beam(400);  // a fine mesh that is held is not taken for one
  for (const frf::Dof& dof : problems::beam_dofs(1)) held.add(problems::Kind::stiffness, {dof, {}}, 1e9);
  EXPECT_TRUE(MatrixModel(matrices_of(held)).receptance(0.0, Indices{801}, Indices{801}));
}

TEST(MatrixModel, NeedsMatricesOfOneSize) {
  StructureMatrices wrong = matrices_of(problems::substructure_a());
  wrong.viscous_damping.resize(3, 3);
  EXPECT_THROW(MatrixModel{wrong}, InputError);
}

TEST(ModalModel, OfAllModesIsTheMatrixModel) {
  const problems::Structure part = problems::substructure_a();
  const Indices coordinates = all(part.size());
  MatrixModel matrices(matrices_of(part));
  ModalModel modal(modes_of(part));
  for (const double frequency : {30.0, 400.0, 1000.0}) {
    EXPECT_LE(difference(*modal.receptance(angular(frequency), coordinates, coordinates),
                         *matrices.receptance(angular(frequency), coordinates, coordinates)),
              1e-9);
  }
  EXPECT_FALSE(modal.receptance(0.0, coordinates, coordinates));  // rigid-body modes
}

/// The six lowest modes of a beam, and what all others do at rest.
TEST(ModalModel, AResidualStandsForTheModesThatAreLeftOut) {
  const problems::Structure part = problems::substructure_a();
  const Indices coordinates = all(part.size());
  const Modes whole = modes_of(part);
  ASSERT_GT(whole.normal.size(), 6u);
  Modes few = whole;
  few.normal.resize(6);
  few.normal_shapes = whole.normal_shapes.leftCols(6);
  Modes with = few;
  with.residual = Eigen::MatrixXcd::Zero(at(part.size()), at(part.size()));
  for (std::size_t k = 6; k < whole.normal.size(); ++k) {
    const NormalMode& mode = whole.normal[k];
    const Eigen::VectorXcd shape = whole.normal_shapes.col(at(k)).cast<Complex>();
    const double stiffness = mode.modal_mass * mode.angular_frequency * mode.angular_frequency;
    with.residual += shape * shape.transpose() / (stiffness * Complex(1.0, mode.loss_factor));
  }
  const double omega = 0.2 * whole.normal[6].angular_frequency;
  const auto error = [&](const Modes& modes) {
    return difference(*ModalModel(modes).receptance(omega, coordinates, coordinates),
                      *ModalModel(whole).receptance(omega, coordinates, coordinates));
  };
  EXPECT_LT(error(with), 0.05 * error(few));  // (ω/ω_7)² of it is left
  EXPECT_GT(error(few), 1e-6);
  with.residual.resize(2, 2);
  EXPECT_THROW(ModalModel{with}, InputError);
}

TEST(ModalModel, AComplexModeIsTheNormalOneOfTheSameDamping) {
  const double omega = 300.0, ratio = 0.02, mass = 2.5;
  Eigen::MatrixXd shape(3, 1);
  shape << 1.0, -0.5, 0.25;
  const double damped = omega * std::sqrt(1.0 - ratio * ratio);
  Modes normal, complex;
  normal.normal_shapes = shape;
  normal.complex_shapes.resize(3, 0);
  normal.normal = {{omega, mass, ratio, 0.0}};
  complex.normal_shapes.resize(3, 0);
  complex.complex_shapes = shape.cast<Complex>();
  complex.complex = {{Complex(-ratio * omega, damped), Complex(0.0, 2.0 * mass * damped)}};
  const Indices coordinates = all(3);
  for (const double at : {0.0, 250.0, 300.0, 900.0}) {
    EXPECT_LE(difference(*ModalModel(complex).receptance(at, coordinates, coordinates),
                         *ModalModel(normal).receptance(at, coordinates, coordinates)),
              1e-12);
  }
}

TEST(ModelSource, IsExactUnlessItSaysHowLarge) {
  const problems::Structure part = problems::substructure_b();
  ModelSource exact = source_of(std::make_unique<MatrixModel>(matrices_of(part)), part, {100.0}),
              noisy = source_of(std::make_unique<MatrixModel>(matrices_of(part)), part, {100.0}, 0.02);
  const Indices line = {0}, two = {1, 4};
  std::vector<Complex> values(4), variances(4);
  exact.read_variance({line, two, two}, variances);
  for (const Complex& variance : variances) EXPECT_EQ(variance, Complex(0.0));
  EXPECT_EQ(exact.model_count().factorizations, 0u);
  noisy.read({line, two, two}, values);
  noisy.read_variance({line, two, two}, variances);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(variances[i].real() / std::norm(values[i]), 2e-4, 1e-15);
  EXPECT_EQ(noisy.model_count().factorizations, 1u);  // remembered from before
  EXPECT_TRUE(is_model(exact.header()));
  EXPECT_FALSE(is_model({}));
}

}  // namespace
}  // namespace jointid::models
