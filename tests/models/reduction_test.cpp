#include "models/reduction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>

#include "base/complex.hpp"
#include "base/eigen.hpp"
#include "base/random.hpp"
#include "models/matrix_model.hpp"
#include "models/model_source.hpp"
#include "problems/solid/solid_matrices.hpp"

namespace jointid::models {
namespace {

using Indices = std::vector<std::size_t>;

double difference(const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

/// Numbers of one random structure.
class Draw {
 public:
  explicit Draw(std::uint64_t trial) : stream_{.seed = 55, .trial = trial} {}
  double between(double low, double high) { return low + (high - low) * uniform_numbers(stream_, entry_++)[0]; }
  int count(int low, int high) { return static_cast<int>(between(low, high + 1.0)); }
  bool coin() { return between(0.0, 1.0) < 0.5; }

 private:
  RandomStream stream_;
  std::uint64_t entry_ = 0;
};

Eigen::SparseMatrix<double> diagonal(Eigen::Index n, const Indices& places, double value) {
  Eigen::SparseMatrix<double> out(n, n);
  for (const std::size_t place : places) out.coeffRef(at(place), at(place)) = value;
  return out;
}

Indices some(Draw& draw, std::size_t size, std::size_t count) {
  std::set<std::size_t> out;
  while (out.size() < count) out.insert(static_cast<std::size_t>(draw.count(0, static_cast<int>(size) - 1)));
  return {out.begin(), out.end()};
}

/// A block of steel, aluminium or rubber-like material, free or on springs, with losses of one kind or several.
StructureMatrices random_structure(Draw& draw) {
  const problems::Solid solid{std::pow(10.0, draw.between(8.0, 11.4)), draw.between(0.1, 0.4), draw.between(1000.0, 8000.0)};
  problems::Block block;
  block.elements = {draw.count(7, 10), draw.count(3, 4), draw.count(2, 3)};
  block.size = {draw.between(0.1, 0.8), draw.between(0.05, 0.3), draw.between(0.02, 0.2)};
  StructureMatrices out = problems::solid_matrices(solid, block);
  const Eigen::Index n = out.mass.rows();
  const double k = out.stiffness.coeff(0, 0);
  if (draw.coin()) out.stiffness += diagonal(n, some(draw, static_cast<std::size_t>(n), 6), 0.01 * k);
  if (draw.coin()) out.loss_factor = draw.between(0.0, 0.05);
  if (draw.coin()) out.hysteretic_damping = draw.between(0.0, 0.02) * out.stiffness;
  if (draw.coin()) {
    const double of_mass = draw.between(0.0, 20.0), of_stiffness = draw.between(0.0, 1e-6);  // in this order with every compiler
    out.viscous_damping = of_mass * out.mass + of_stiffness * out.stiffness;
  } else if (draw.coin()) {
    out.viscous_damping = diagonal(n, some(draw, static_cast<std::size_t>(n), 5), 1e-5 * k);
    if (draw.coin()) out.viscous_damping += 5.0 * out.mass;
  }
  return out;
}

/// About the first elastic resonances: a bending mode of the longest edge is far below √(E/ρ)/L.
std::vector<double> lines_of(const StructureMatrices& matrices, std::size_t count) {
  const double fastest = std::sqrt(matrices.stiffness.diagonal().maxCoeff() / matrices.mass.diagonal().maxCoeff());
  std::vector<double> out;
  for (std::size_t i = 0; i < count; ++i)
    out.push_back(fastest * (0.02 + 0.1 * static_cast<double>(i) / static_cast<double>(count - 1)));
  return out;
}

TEST(Reduction, IsWithinItsBoundOfTheFactorisationOnFortyRandomStructures) {
  double worst = 0.0;
  for (std::uint64_t trial = 0; trial < 40; ++trial) {
    Draw draw(trial);
    const StructureMatrices matrices = random_structure(draw);
    const Indices asked = some(draw, static_cast<std::size_t>(matrices.mass.rows()), static_cast<std::size_t>(draw.count(1, 8)));
    const std::vector<double> omega = lines_of(matrices, 40);
    MatrixModel reduced(matrices, MatrixModel::Factors::sparse), exact(matrices, MatrixModel::Factors::sparse);
    reduced.expect({omega, omega.front(), omega.back(), asked});
    ASSERT_NE(reduced.reduction(), nullptr) << trial;
    EXPECT_LE(reduced.reduction()->error(), Reduction::rounding) << trial;
    for (const std::size_t line : {std::size_t{3}, std::size_t{20}, std::size_t{39}}) {
      const auto found = reduced.receptance(omega[line], asked, asked), expected = exact.receptance(omega[line], asked, asked);
      ASSERT_TRUE(found && expected) << trial;
      const double off = difference(*found, *expected);
      worst = std::max(worst, off);
      EXPECT_LE(off, 1e-9) << "structure " << trial << ", line " << line;
    }
    EXPECT_EQ(reduced.count().factorizations, 1u) << "one line is compared";
    EXPECT_EQ(reduced.count().reduced, 3u);
  }
  EXPECT_GT(worst, 0.0);  // another way of calculating, not the same one
}

TEST(PositiveFactors, OfBothLibrariesSolveAlike) {
  const StructureMatrices matrices =
      problems::solid_matrices({2e11, 0.3, 7800.0}, {.size = {0.3, 0.2, 0.1}, .elements = {5, 4, 3}});
  const Eigen::SparseMatrix<double> positive = matrices.stiffness + 1e6 * matrices.mass;
  const Eigen::MatrixXd right = Eigen::MatrixXd::Identity(positive.rows(), 5);
  ASSERT_TRUE(has_cholmod()) << "module cholmod is built where SuiteSparse is";
  Eigen::MatrixXd first;
  for (const Eigen::Index rows : {Eigen::Index{10}, Eigen::Index{100'000}}) {
    const auto factors = positive_factors(rows);
    EXPECT_EQ(factors->is_supernodal(), rows > 10);
    EXPECT_FALSE(factors->factorize(matrices.stiffness - 1e6 * matrices.mass)) << "not positive definite";
    ASSERT_TRUE(factors->factorize(positive));
    const Eigen::MatrixXd x = factors->solve(right);
    EXPECT_LE((positive * x - right).cwiseAbs().maxCoeff(), 1e-9);
    if (rows == 10) first = x;
    EXPECT_LE((x - first).cwiseAbs().maxCoeff(), 1e-10 * first.cwiseAbs().maxCoeff());
  }
}

/// Positive definite factors are far cheaper there: no other is needed.
TEST(Reduction, OfLargeStructuresTakesPowersInPlaceOfShifts) {
  StructureMatrices matrices =
      problems::solid_matrices({2.1e11, 0.3, 7800.0}, {.size = {0.5, 0.25, 0.25}, .elements = {9, 9, 3}});
  matrices.loss_factor = 0.005;
  ASSERT_GE(matrices.mass.rows(), 1000);
  const Indices asked = {0, 100, 433, 900};
  const std::vector<double> omega = {angular(200.0), angular(1777.0), angular(3000.0)};
  Reduction reduction(matrices, *proportional_form(matrices, 64), asked);
  ASSERT_TRUE(reduction.cover(omega.front(), omega.back(), 300));
  EXPECT_EQ(reduction.shifts(), 0u);
  EXPECT_LE(reduction.error(), Reduction::accepted);
  MatrixModel exact(matrices, MatrixModel::Factors::sparse);
  for (const double each : omega)
    EXPECT_LE(difference(*reduction.receptance(each, asked, asked), *exact.receptance(each, asked, asked)), 1e-9);
}

TEST(Reduction, GivesUpWhereTheBasisMayNotBeLargeEnough) {
  Draw draw(7);
  const StructureMatrices matrices = random_structure(draw);
  const auto form = proportional_form(matrices, 64);
  ASSERT_TRUE(form);
  const std::vector<double> omega = lines_of(matrices, 2);
  Reduction few(matrices, *form, {0, 7, 31});
  EXPECT_FALSE(few.cover(omega.front(), omega.back(), 6)) << "six vectors are those that it begins with";
}

TEST(Reduction, LeavesGeneralDampingToTheFactorisation) {
  StructureMatrices matrices = problems::solid_matrices({2e11, 0.3, 7800.0}, {.size = {0.3, 0.2, 0.1}, .elements = {4, 3, 2}});
  matrices.viscous_damping = matrices.mass.cwiseProduct(matrices.mass) * 1e3;
  EXPECT_FALSE(proportional_form(matrices, 64));
  const std::vector<double> omega = lines_of(matrices, 20);
  const Indices asked = {1, 5};
  MatrixModel model(matrices, MatrixModel::Factors::sparse);
  model.expect({omega, omega.front(), omega.back(), asked});
  EXPECT_EQ(model.reduction(), nullptr);
  ASSERT_TRUE(model.receptance(omega[4], asked, asked));
  EXPECT_EQ(model.count().factorizations, 1u);
  const ModelUse use = model.use(20, 2);
  EXPECT_EQ(use.way, ModelWay::factorised);
  EXPECT_NE(use.reason.find("damping is no combination"), std::string::npos) << use.reason;
}

/// What is expected of 20 lines, and what was done.
TEST(MatrixModel, StatesHowItsFrfsAreComputed) {
  StructureMatrices matrices = problems::solid_matrices({2e11, 0.3, 7800.0}, {.size = {0.3, 0.2, 0.1}, .elements = {8, 3, 2}});
  matrices.loss_factor = 0.01;
  const std::vector<double> omega = lines_of(matrices, 20);
  const Indices asked = {1, 5, 100};
  MatrixModel model(matrices, MatrixModel::Factors::sparse);
  EXPECT_EQ(model.use(11, 3).reason, "fewer than 12 lines");
  const ModelUse before = model.use(20, 3);
  EXPECT_EQ(before.way, ModelWay::reduced);
  EXPECT_EQ(before.vectors, 0u);
  EXPECT_EQ(before.expected_vectors, 24u);
  EXPECT_GT(model.use(20, 30).expected_bytes, before.expected_bytes);
  EXPECT_GT(model.use(20, 30).expected_seconds, before.expected_seconds);
  model.expect({omega, omega.front(), omega.back(), asked});
  for (const double each : omega) ASSERT_TRUE(model.receptance(each, asked, asked));
  const ModelUse after = model.use(20, 3);
  ASSERT_NE(model.reduction(), nullptr);
  EXPECT_EQ(after.vectors, static_cast<std::size_t>(model.reduction()->vectors()));
  EXPECT_EQ(after.shifts, model.reduction()->shifts());
  EXPECT_EQ(after.error, model.reduction()->error());
  EXPECT_EQ(after.bound, Reduction::bound);
  EXPECT_NEAR(after.worst_hz, hertz(model.reduction()->worst_omega()), 1e-9);
  EXPECT_EQ(after.reduced_lines, 20u);
  EXPECT_EQ(after.factorizations, 1u) << "the line that is compared";
  EXPECT_EQ(MatrixModel(matrices, MatrixModel::Factors::full).use(20, 3).way, ModelWay::full);
}

TEST(ProportionalForm, FindsTheSharesOfMassAndStiffness) {
  StructureMatrices matrices = problems::solid_matrices({7e10, 0.33, 2700.0}, {.size = {0.3, 0.2, 0.1}, .elements = {3, 2, 2}});
  matrices.loss_factor = 0.01;
  matrices.hysteretic_damping = 0.002 * matrices.stiffness;
  matrices.viscous_damping = 3.0 * matrices.mass + 2e-6 * matrices.stiffness;
  const auto form = proportional_form(matrices, 0);
  ASSERT_TRUE(form);
  EXPECT_NEAR(form->loss, 0.012, 1e-14);
  EXPECT_NEAR(form->c_m, 3.0, 1e-9);
  EXPECT_NEAR(form->c_k, 2e-6, 1e-17);
  EXPECT_TRUE(form->dampers.empty());
}

TEST(ProportionalForm, LeavesWhatIsAtFewCoordinates) {
  StructureMatrices matrices = problems::solid_matrices({7e10, 0.33, 2700.0}, {.size = {0.3, 0.2, 0.1}, .elements = {4, 3, 2}});
  const Eigen::Index n = matrices.mass.rows();
  matrices.hysteretic_damping = 0.002 * matrices.stiffness + diagonal(n, {3, 44, 90}, 4e5);
  matrices.stiffness += diagonal(n, {3, 44, 90}, 1e7);  // the springs whose loss that is
  const auto form = proportional_form(matrices, 3);
  ASSERT_TRUE(form);
  EXPECT_NEAR(form->loss, 0.002, 1e-14);
  EXPECT_EQ(form->dampers, (Indices{3, 44, 90}));
  EXPECT_NEAR(form->rest_d(1, 1), 4e5 - 0.002 * 1e7, 1e-4);
  EXPECT_FALSE(proportional_form(matrices, 2));
}

/// Blocks of lines and DOFs as readers ask for them: the basis grows, and few lines are factorised as before.
TEST(ModelSource, ReadsManyLinesOfALargeModelWithoutAFactorisationOfEach) {
  const StructureMatrices matrices = problems::solid_matrices({2.1e11, 0.3, 7800.0}, {.size = {0.5, 0.3, 0.1}, .elements = {6, 4, 1}});
  const auto source_of = [&](std::size_t lines) {
    NamedCoordinates names;
    for (const std::size_t place : {0u, 4u, 50u, 103u}) {
      names.dofs.push_back(frf::Dof::parse(std::to_string(place + 1) + ":+X"));
      names.coordinates.push_back(place);
    }
    StructureMatrices own = matrices;
    own.loss_factor = 0.01;
    std::vector<double> hz;
    for (std::size_t i = 0; i < lines; ++i) hz.push_back(500.0 + 10.0 * static_cast<double>(i));
    return ModelSource({.file = "block.toml", .model = std::make_unique<MatrixModel>(std::move(own), MatrixModel::Factors::sparse),
                        .coordinates = names}, std::move(hz));
  };
  const auto read = [](ModelSource& source, const Indices& lines, const Indices& responses, const Indices& references) {
    std::vector<Complex> values(lines.size() * responses.size() * references.size());
    source.read({lines, responses, references}, values);
    return values;
  };
  const auto range = [](std::size_t first, std::size_t count) {
    Indices out(count);
    std::iota(out.begin(), out.end(), first);
    return out;
  };
  ModelSource few = source_of(200), many = source_of(200);
  std::vector<Complex> expected;
  for (std::size_t line = 0; line < 10; ++line) {  // each by itself: fewer than a reduction is worth
    for (const Complex value : read(few, {20 * line}, {0, 1, 2, 3}, {0, 2})) expected.push_back(value);
  }
  EXPECT_EQ(few.model_count().factorizations, 10u);
  for (std::size_t first = 0; first < 200; first += 25) read(many, range(first, 25), {0, 1}, {0});
  const std::size_t factorised = many.model_count().factorizations;
  EXPECT_LE(factorised, 2u);  // ranges are doubled, and one line is compared where the basis grew
  Indices lines;
  for (std::size_t line = 0; line < 10; ++line) lines.push_back(20 * line);
  const std::vector<Complex> found = read(many, lines, {0, 1, 2, 3}, {0, 2});
  EXPECT_EQ(many.model_count().factorizations, factorised + 1);  // other DOFs, another basis
  ASSERT_EQ(found.size(), expected.size());
  double largest = 0.0;
  for (const Complex value : expected) largest = std::max(largest, std::abs(value));
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_LE(std::abs(found[i] - expected[i]), 1e-9 * largest) << i;
}

}  // namespace
}  // namespace jointid::models
