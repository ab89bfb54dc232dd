// Mixing and expansion against an independent program, and their invariants.
#include "correlation/expansion.hpp"

#include <gtest/gtest.h>

#include <random>

#include "base/error.hpp"
#include "dense/lu.hpp"
#include "tests/correlation/golden_case.hpp"

namespace jointid::correlation {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Complex = std::complex<double>;

double apart(const MatrixXcd& one, const MatrixXcd& other) {
  return (one - other).cwiseAbs().maxCoeff() / other.cwiseAbs().maxCoeff();
}

TEST(GoldenExpansion, Semm) {
  CORRELATION_CASE(given, "expansion");
  const auto parent = golden::lines(given["given"]["parent"], 4), truth = golden::lines(given["given"]["overlay_of"], 4),
             basic = golden::lines(given["expected"]["semm"]["basic"], 4),
             extended = golden::lines(given["expected"]["semm"]["extended"], 4);
  const Places b = golden::places(given["given"]["overlay_coordinates"]);
  for (std::size_t i = 0; i < parent.size(); ++i) {
    const MatrixXcd overlay = truth[i](b, b);
    EXPECT_LT(apart(mixed(parent[i], overlay, b, Semm::basic), basic[i]), 2e-9) << i;
    EXPECT_LT(apart(mixed(parent[i], overlay, b, Semm::extended), extended[i]), 2e-9) << i;
  }
}

TEST(GoldenExpansion, Serep) {
  CORRELATION_CASE(given, "expansion");
  const golden::json& expected = given["expected"]["serep"];
  const Index kept = expected["modes_kept"].get<Index>();
  const Places b = golden::places(expected["coordinates"]);
  const MatrixXcd shapes = golden::real_matrix(given["given"]["modes_parent"]).cast<Complex>().leftCols(kept),
                  truth = golden::real_matrix(given["given"]["modes_true"]).cast<Complex>().leftCols(kept),
                  to_all = serep(shapes, b);
  EXPECT_LT(apart(to_all, golden::real_matrix(expected["T"]).cast<Complex>()), 2e-9);
  EXPECT_LT(apart(to_all * truth(b, Eigen::all), golden::real_matrix(expected["expanded"]).cast<Complex>()), 2e-9);
}

struct DrawnModel : testing::TestWithParam<unsigned> {
  std::mt19937 generator{GetParam()};

  MatrixXcd draw(Index rows, Index columns) {
    std::normal_distribution<double> normal;
    return MatrixXcd::NullaryExpr(rows, columns, [&] { return Complex(normal(generator), normal(generator)); });
  }

  MatrixXcd symmetric(Index n) {
    const MatrixXcd a = draw(n, n);
    return a + a.transpose();
  }
};

/// The overlay at b, the parent where the overlay is that of the parent, a change of the dynamic stiffness at b alone.
TEST_P(DrawnModel, Semm) {
  const Places b = {4, 0, 2};
  const MatrixXcd parent = symmetric(6), overlay = symmetric(3);
  for (const Semm way : {Semm::basic, Semm::extended}) {
    EXPECT_LT(apart(mixed(parent, overlay, b, way)(b, b), overlay), 1e-9);
    EXPECT_LT(apart(mixed(parent, parent(b, b), b, way), parent), 1e-12);
    const MatrixXcd mix = mixed(parent, overlay, b, way);
    EXPECT_LT(apart(mix, mix.transpose()), 1e-9);  // reciprocal
  }
  MatrixXcd change = dense::inverse(mixed(parent, overlay, b, Semm::basic)) - dense::inverse(parent);
  const MatrixXcd at_b = dense::inverse(overlay) - dense::inverse(MatrixXcd(parent(b, b)));
  EXPECT_LT(apart(change(b, b), at_b), 1e-7);
  for (const Index i : b) {
    for (const Index j : b) change(i, j) = 0.0;
  }
  EXPECT_LT(change.cwiseAbs().maxCoeff(), 1e-7 * at_b.cwiseAbs().maxCoeff());
}

/// Motions of the kept modes are exact.
TEST_P(DrawnModel, Serep) {
  const Places b = {5, 1, 3, 0};
  const MatrixXcd shapes = draw(8, 3), motion = shapes * draw(3, 2);
  EXPECT_LT(apart(serep(shapes, b) * motion(b, Eigen::all), motion), 1e-11);
}

INSTANTIATE_TEST_SUITE_P(Seeds, DrawnModel, testing::Range(1u, 13u));

TEST(Serep, RefusesMoreModesThanCoordinatesTellApart) {
  MatrixXcd shapes = MatrixXcd::Identity(4, 2);
  try {
    serep(shapes, {0, 2});  // the second mode does not move there
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_NE(error.parts().problem.find("2 modes"), std::string::npos);
    EXPECT_NE(error.parts().remedy.find("keep at most"), std::string::npos);
  }
}

}  // namespace
}  // namespace jointid::correlation
