#include "response/harmonic/left_out.hpp"

#include <algorithm>

#include "dense/real_lu.hpp"
#include "response/harmonic/attempts.hpp"

namespace jointid::response {
namespace {

/// Known everywhere: at the nearest line.
class NearestLine final : public Receptance {
 public:
  explicit NearestLine(const Receptance& own) : own_(own) {}

  Eigen::Index joints() const override { return own_.joints(); }
  Eigen::Index responses() const override { return own_.responses(); }
  Eigen::Index forces() const override { return own_.forces(); }
  bool covers(double) const override { return true; }
  Eigen::MatrixXcd at(double omega) const override { return own_.at(own_.covers(omega) ? omega : own_.nearest(omega)); }
  std::optional<Eigen::MatrixXcd> derivative(double) const override { return std::nullopt; }

 private:
  const Receptance& own_;
};

}  // namespace

Eigen::MatrixXd left_out(const HarmonicBalance& balance, const HarmonicSolution& solution) {
  if (solution.dropped.empty()) return {};
  std::vector<int> numbers = solution.harmonics;
  for (const DroppedHarmonic& dropped : solution.dropped) numbers.push_back(dropped.harmonic);
  std::ranges::sort(numbers);
  const CondensedEquations equations(balance.joints(), Harmonics(numbers));
  const HarmonicLine line =
      harmonic_line(NearestLine(balance.structure()), equations.harmonics(), balance.force(), solution.omega);
  const Eigen::VectorXd motion = embedded(equations, solution.harmonics, solution.joint_motion);
  const auto [residual, by_motion] = equations.evaluate(line, solution.level, motion);
  const Eigen::VectorXd change = -dense::RealLu(by_motion).solve(residual);
  const std::vector<Eigen::MatrixXcd> slopes = equations.forces_by_motion(solution.omega, motion);
  Eigen::MatrixXd bars(solution.response.rows(), solution.response.cols());
  for (Eigen::Index n = 0; n < bars.rows(); ++n) {
    const auto place = static_cast<std::size_t>(equations.harmonics().find(solution.harmonics[static_cast<std::size_t>(n)]));
    const Eigen::VectorXcd force = slopes[place] * change;
    bars.row(n) = (line.harmonics[place].to_joints * force).cwiseAbs().transpose();
  }
  return bars;
}

}  // namespace jointid::response
