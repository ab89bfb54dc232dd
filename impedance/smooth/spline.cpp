#include "impedance/smooth/spline.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include "dense/cholesky.hpp"
#include "minimise/least_value.hpp"

namespace jointid::impedance {
namespace {

using Index = Eigen::Index;

/// The four B-splines that are not zero at w of an interval of knots, 0 ≤ w ≤ 1.
std::array<double, 4> cubic_splines(double w) {
  const double v = 1.0 - w;
  return {v * v * v / 6.0, (3.0 * w * w * w - 6.0 * w * w + 4.0) / 6.0, (-3.0 * w * w * w + 3.0 * w * w + 3.0 * w + 1.0) / 6.0,
          w * w * w / 6.0};
}

class Spline {
 public:
  Spline(const std::vector<double>& hz, const Eigen::VectorXcd& z, const Eigen::VectorXd& variance, std::size_t splines)
      : z_(z), variance_(variance), basis_(Eigen::MatrixXd::Zero(z.size(), static_cast<Index>(splines))) {
    const auto count = static_cast<Index>(splines);
    const double step = (hz.back() - hz.front()) / static_cast<double>(count - 3);
    for (Index q = 0; q < z.size(); ++q) {
      const double place = (hz[static_cast<std::size_t>(q)] - hz.front()) / step;
      const Index interval = std::clamp<Index>(static_cast<Index>(place), 0, count - 4);
      const auto values = cubic_splines(place - static_cast<double>(interval));
      for (Index k = 0; k < 4; ++k) basis_(q, interval + k) = values[static_cast<std::size_t>(k)];
    }
    Eigen::MatrixXd second = Eigen::MatrixXd::Zero(count - 2, count);
    for (Index k = 0; k < count - 2; ++k) second.block(k, k, 1, 3) << 1.0, -2.0, 1.0;
    penalty_ = second.transpose() * second;
    normal_ = basis_.transpose() * variance_.cwiseInverse().asDiagonal() * basis_;
    right_ = basis_.transpose() * variance_.cwiseInverse().asDiagonal() * z_;
  }

  /// The size of λ where the penalty weighs as much as the data.
  double usual() const { return normal_.trace() / penalty_.trace(); }

  SplineFit at(double lambda) const {
    SplineFit out;
    out.lambda = lambda;
    const Eigen::MatrixXd matrix = normal_ + lambda * penalty_;
    const auto lower = dense::cholesky(matrix);
    if (!lower) {
      out.gcv = out.cp = out.marginal = std::numeric_limits<double>::infinity();
      return out;
    }
    const Eigen::MatrixXd inverse = dense::solve_positive(matrix, Eigen::MatrixXd::Identity(matrix.rows(), matrix.cols()));
    out.coefficients = inverse * right_;
    out.z = basis_ * out.coefficients;
    const Eigen::MatrixXd smoother = basis_ * inverse * basis_.transpose() * variance_.cwiseInverse().asDiagonal();
    out.degrees = smoother.trace();
    out.rss = ((z_ - out.z).cwiseAbs2().array() / variance_.array()).sum();
    const double n = static_cast<double>(z_.size()), k = static_cast<double>(matrix.rows());
    out.gcv = n * out.rss / std::pow(n - out.degrees, 2);
    out.cp = out.rss + 2.0 * out.degrees;
    const double rough = (out.coefficients.adjoint() * (penalty_ * out.coefficients)).value().real();
    out.marginal = out.rss + lambda * rough + 2.0 * lower->diagonal().array().log().sum() - (k - 2.0) * std::log(lambda);
    out.variance = (basis_ * inverse * basis_.transpose()).diagonal();
    out.variance_sampling = (smoother * variance_.asDiagonal() * smoother.transpose()).diagonal();
    return out;
  }

 private:
  const Eigen::VectorXcd& z_;
  const Eigen::VectorXd& variance_;
  Eigen::MatrixXd basis_, penalty_, normal_;
  Eigen::VectorXcd right_;
};

}  // namespace

const std::vector<std::string>& smoothing_names() {
  static const std::vector<std::string> words = {"marginal", "gcv", "cp"};
  return words;
}

std::string name(Smoothing smoothing) {
  return smoothing == Smoothing::given ? "given" : smoothing_names()[static_cast<std::size_t>(smoothing)];
}

SplineFit fit_spline(const std::vector<double>& hz, const Eigen::VectorXcd& z, const Eigen::VectorXd& variance,
                     std::size_t splines, Smoothing smoothing, double lambda) {
  assert(splines >= 4 && z.size() >= 4);
  const Spline spline(hz, z, variance, splines);
  const auto criterion = [smoothing](const SplineFit& fit) {
    return smoothing == Smoothing::gcv ? fit.gcv : smoothing == Smoothing::cp ? fit.cp : fit.marginal;
  };
  if (smoothing == Smoothing::given) {
    SplineFit out = spline.at(lambda);
    out.criterion = std::nan("");
    return out;
  }
  const double usual = std::log(spline.usual());
  const double best = least_over([&](double x) { return criterion(spline.at(std::exp(x))); }, usual - 16.0, usual + 16.0, 60, 1e-7);
  SplineFit out = spline.at(std::exp(best));
  out.criterion = criterion(out);
  return out;
}

}  // namespace jointid::impedance
