#include "response/structure/sparse_receptance.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "base/error.hpp"
#include "response/structure/matrix_receptance.hpp"

namespace jointid::response {
namespace {

/// n masses between springs, a little uneven, the first to ground.
MatrixStructure masses(Eigen::Index n) {
  MatrixStructure all = {Eigen::MatrixXd::Identity(n, n), {}, Eigen::MatrixXd::Zero(n, n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    const double spring = 1000.0 + 10.0 * static_cast<double>(i % 7);
    all.mass(i, i) += 0.1 * static_cast<double>(i % 3);
    all.stiffness(i, i) += spring;
    if (i == 0) continue;
    all.stiffness(i - 1, i - 1) += spring;
    all.stiffness(i, i - 1) = all.stiffness(i - 1, i) = -spring;
  }
  all.damping = 2e-4 * all.stiffness + 0.05 * all.mass;
  return all;
}

SparseStructure sparse(const MatrixStructure& all) {
  return {all.mass.sparseView(), all.damping.sparseView(), all.stiffness.sparseView()};
}

struct Places {
  Eigen::MatrixXd joints, responses, forces;
};

Places places(Eigen::Index n) {
  Places all = {Eigen::MatrixXd::Zero(n, 2), Eigen::MatrixXd::Identity(n, 3), Eigen::MatrixXd::Identity(n, 1)};
  all.joints(4, 0) = 1.0;
  all.joints(6, 1) = 1.0;
  all.joints(n - 1, 1) = -1.0;
  return all;
}

TEST(SparseReceptance, IsTheDenseOne) {
  for (const Eigen::Index n : {18, 120}) {
    const auto [w, r, f] = places(n);
    const MatrixReceptance full(masses(n), w, r, f);
    const SparseReceptance found(sparse(masses(n)), w, r, f);
    EXPECT_EQ(found.joints(), 2);
    EXPECT_EQ(found.responses(), 3);
    EXPECT_EQ(found.forces(), 1);
    for (const double omega : {0.0, 3.0, 11.0, 47.0, 400.0}) {
      const Eigen::MatrixXcd expected = full.at(omega), slope = *full.derivative(omega);
      EXPECT_LE((found.at(omega) - expected).cwiseAbs().maxCoeff(), 1e-10 * expected.cwiseAbs().maxCoeff()) << n << " " << omega;
      EXPECT_LE((*found.derivative(omega) - slope).cwiseAbs().maxCoeff(), 1e-9 * slope.cwiseAbs().maxCoeff())
          << n << " " << omega;
    }
  }
}

TEST(SparseReceptance, RefusesWhatDoesNotFit) {
  const auto [w, r, f] = places(18);
  EXPECT_THROW(SparseReceptance(sparse(masses(18)), places(20).joints, r, f), InputError);
  SparseStructure other = sparse(masses(18));
  other.damping = sparse(masses(20)).damping;
  EXPECT_THROW(SparseReceptance(other, w, r, f), InputError);
  other = sparse(masses(18));
  other.mass.coeffRef(3, 3) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(SparseReceptance(other, w, r, f), InputError);
  SparseStructure free = sparse(masses(18));
  free.stiffness.setZero();
  free.damping.setZero();
  EXPECT_THROW(SparseReceptance(free, w, r, f).at(0.0), InputError);
}

}  // namespace
}  // namespace jointid::response
