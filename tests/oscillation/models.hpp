#pragma once

#include <vector>

#include "oscillation/tangent/spectrum.hpp"

namespace jointid::oscillation {

/// x' = 1 − a x² + y, y' = b x.
inline TangentStep henon(double a, double b) {
  return [a, b](Eigen::VectorXd& z, Eigen::MatrixXd& tangents) {
    const double x = z(0), y = z(1);
    if (tangents.cols() > 0) {
      Eigen::Matrix2d slope;
      slope << -2.0 * a * x, 1.0, b, 0.0;
      tangents = slope * tangents;
    }
    z << 1.0 - a * x * x + y, b * x;
  };
}

struct Lorenz {
  double sigma = 10.0, rho = 28.0, beta = 8.0 / 3.0;

  /// Taylor series of order 20 over `time`, which is far within its radius of convergence; tangents by the same series.
  void advance(Eigen::VectorXd& z, Eigen::MatrixXd& tangents, double time) const {
    constexpr std::size_t order = 20;
    const Eigen::Index count = tangents.cols();
    std::vector<Eigen::Vector3d> c(order + 1);
    std::vector<Eigen::MatrixXd> w(order + 1, Eigen::MatrixXd::Zero(3, count));
    c[0] = z;
    w[0] = tangents;
    for (std::size_t k = 0; k < order; ++k) {
      double xz = 0.0, xy = 0.0;
      Eigen::RowVectorXd wxz = Eigen::RowVectorXd::Zero(count), wxy = wxz;
      for (std::size_t j = 0; j <= k; ++j) {
        xz += c[j](0) * c[k - j](2);
        xy += c[j](0) * c[k - j](1);
        wxz += w[j].row(0) * c[k - j](2) + c[j](0) * w[k - j].row(2);
        wxy += w[j].row(0) * c[k - j](1) + c[j](0) * w[k - j].row(1);
      }
      c[k + 1] << sigma * (c[k](1) - c[k](0)), rho * c[k](0) - xz - c[k](1), xy - beta * c[k](2);
      c[k + 1] /= static_cast<double>(k + 1);
      w[k + 1].row(0) = sigma * (w[k].row(1) - w[k].row(0)) / (static_cast<double>(k + 1));
      w[k + 1].row(1) = (rho * w[k].row(0) - wxz - w[k].row(1)) / (static_cast<double>(k + 1));
      w[k + 1].row(2) = (wxy - beta * w[k].row(2)) / (static_cast<double>(k + 1));
    }
    Eigen::Vector3d sum = c[order];
    for (std::size_t k = order; k-- > 0;) {
      sum = c[k] + time * sum;
      w[order] = w[k] + time * w[order];
    }
    z = sum;
    tangents = w[order];
  }

  TangentStep step(double time) const {
    return [*this, time](Eigen::VectorXd& z, Eigen::MatrixXd& tangents) { advance(z, tangents, time); };
  }
};

}  // namespace jointid::oscillation
