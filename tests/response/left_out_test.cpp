#include "response/harmonic/left_out.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "friction/law/laws.hpp"
#include "response/structure/matrix_receptance.hpp"

namespace jointid::response {
namespace {

/// A structure that is known up to a frequency.
class UpTo final : public Receptance {
 public:
  UpTo(MatrixReceptance own, double last) : own_(std::move(own)), last_(last) {}

  Eigen::Index joints() const override { return own_.joints(); }
  Eigen::Index responses() const override { return own_.responses(); }
  Eigen::Index forces() const override { return own_.forces(); }
  bool covers(double omega) const override { return omega <= last_; }
  Eigen::MatrixXcd at(double omega) const override { return own_.at(omega); }
  std::optional<Eigen::MatrixXcd> derivative(double omega) const override { return own_.derivative(omega); }
  double nearest(double omega) const override { return std::min(omega, last_); }

 private:
  MatrixReceptance own_;
  double last_;
};

MatrixReceptance masses() {
  const Eigen::MatrixXd m = Eigen::Vector3d(1.0, 1.2, 0.9).asDiagonal(), all = Eigen::MatrixXd::Identity(3, 3);
  Eigen::MatrixXd k(3, 3), w(3, 1);
  k << 500.0, -200.0, 0.0, -200.0, 250.0, -50.0, 0.0, -50.0, 150.0;
  w << 0.0, 1.0, -1.0;
  return {{m, 2e-3 * k, k}, w, all, all.leftCols(1)};
}

HarmonicBalance balance(double last, std::vector<int> harmonics) {
  const Joint joint = {.name = "joint", .friction = friction::make_element("bilinear", std::vector{0.01, 150.0})};
  return {std::make_shared<UpTo>(masses(), last), {joint}, Excitation::single(12.0), {.fixed = std::move(harmonics)}};
}

/// The bar of harmonic 5, known a little below it, is what the harmonic changes.
TEST(LeftOut, IsWhatTheHarmonicChanges) {
  for (const double omega : {7.0, 13.0, 19.0}) {
    const HarmonicBalance shorter = balance(4.98 * omega, {1, 3, 5});
    const HarmonicSolution without = shorter.solve(omega), with = balance(1e3, {1, 3, 5}).solve(omega);
    ASSERT_TRUE(without.converged && with.converged);
    ASSERT_EQ(without.harmonics, (std::vector<int>{1, 3}));
    const Eigen::MatrixXd bars = left_out(shorter, without);
    ASSERT_EQ(bars.rows(), 2);
    const Eigen::MatrixXd change = (with.response.topRows(2) - without.response).cwiseAbs();
    EXPECT_LE((bars - change).cwiseAbs().maxCoeff(), 0.25 * change.maxCoeff()) << omega;
    EXPECT_GT(change.maxCoeff(), 0.0);
  }
}

TEST(LeftOut, IsEmptyWhereNothingWasDropped) {
  const HarmonicBalance all = balance(1e3, {1, 3, 5});
  EXPECT_EQ(left_out(all, all.solve(13.0)).size(), 0);
}

}  // namespace
}  // namespace jointid::response
