#pragma once

#include <cmath>
#include <complex>
#include <optional>
#include <random>
#include <vector>

#include "response/structure/matrix_receptance.hpp"

namespace jointid::response {

/// Receptances with an error of each element of the upper triangle, real and imaginary part by a share of its size.
class NoisyReceptance final : public Receptance {
 public:
  NoisyReceptance(const MatrixStructure& matrices, Eigen::MatrixXd w, const Eigen::MatrixXd& seen, const Eigen::MatrixXd& forces,
                  double noise)
      : all_(matrices, Eigen::MatrixXd(matrices.mass.rows(), 0),
             Eigen::MatrixXd::Identity(matrices.mass.rows(), matrices.mass.rows()),
             Eigen::MatrixXd::Identity(matrices.mass.rows(), matrices.mass.rows())),
        joints_(w.cols()),
        left_(w.rows(), w.cols() + seen.cols()),
        right_(w.rows(), w.cols() + forces.cols()),
        noise_(noise) {
    left_ << w, seen;
    right_ << w, forces;
  }
  /// Errors are drawn for every frequency by itself.
  void disturb(unsigned long seed) { seed_ = seed; }

  Eigen::Index joints() const override { return joints_; }
  Eigen::Index responses() const override { return left_.cols() - joints_; }
  Eigen::Index forces() const override { return right_.cols() - joints_; }
  bool covers(double) const override { return true; }
  Eigen::MatrixXcd at(double omega) const override {
    Eigen::MatrixXcd h = all_.at(omega);
    if (seed_ > 0) {
      std::mt19937_64 generator(seed_ + static_cast<unsigned long>(std::lround(1e3 * omega)) * 1000UL);
      std::normal_distribution<double> normal;
      for (Eigen::Index j = 0; j < h.cols(); ++j) {
        for (Eigen::Index i = 0; i <= j; ++i) {
          const double size = noise_ * std::abs(h(i, j)), re = normal(generator), im = normal(generator);
          h(i, j) += size * Complex(re, im);
          h(j, i) = h(i, j);
        }
      }
    }
    return left_.transpose() * h * right_;
  }
  std::optional<Eigen::MatrixXcd> derivative(double) const override { return std::nullopt; }
  std::vector<ReceptanceError> errors(double omega) const override {
    const Eigen::MatrixXcd h = all_.at(omega);
    std::vector<ReceptanceError> all;
    for (Eigen::Index j = 0; j < h.cols(); ++j) {
      for (Eigen::Index i = 0; i <= j; ++i) {
        Eigen::MatrixXd shape = left_.row(i).transpose() * right_.row(j);
        if (i != j) shape += left_.row(j).transpose() * right_.row(i);
        const double variance = noise_ * noise_ * std::norm(h(i, j));
        all.push_back({shape, Complex(variance, variance)});
      }
    }
    return all;
  }

 private:
  MatrixReceptance all_;
  Eigen::Index joints_;
  Eigen::MatrixXd left_, right_;
  double noise_;
  unsigned long seed_ = 0;
};

}  // namespace jointid::response
