#include "ident/likelihood/fit/secant_steps.hpp"

#include <vector>

#include "minimise/linear/covariance.hpp"

namespace jointid::ident {
namespace {

constexpr std::size_t remembered = 8;
constexpr double least_secant = 0.1, most_secant = 10.0;  // in that of the information

}  // namespace

Eigen::VectorXd SecantSteps::step(const Eigen::MatrixXd& information, const Eigen::VectorXd& gradient) const {
  Eigen::VectorXd rest = gradient;
  std::vector<double> shares(pairs_.size());
  for (std::size_t k = pairs_.size(); k-- > 0;) {
    const Pair& pair = pairs_[k];
    shares[k] = pair.step.dot(rest) / pair.step.dot(pair.fall);
    rest -= shares[k] * pair.fall;
  }
  Eigen::VectorXd step = minimise::determined_step(information, rest);
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const Pair& pair = pairs_[k];
    step += (shares[k] - pair.fall.dot(step) / pair.step.dot(pair.fall)) * pair.step;
  }
  return step;
}

void SecantSteps::note(const Eigen::VectorXd& step, const Eigen::VectorXd& fall, const Eigen::MatrixXd& information) {
  const double curvature = step.dot(fall) / step.dot(information * step);
  if (!(curvature > least_secant && curvature < most_secant)) return;
  if (pairs_.size() == remembered) pairs_.pop_front();
  pairs_.push_back({step, fall});
}

}  // namespace jointid::ident
