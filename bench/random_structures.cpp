#include "bench/random_structures.hpp"

#include <Eigen/Core>
#include <cmath>
#include <numbers>

#include "base/complex.hpp"
#include "dense/lu.hpp"

namespace jointid::bench {
namespace {

using Matrix = Eigen::MatrixXcd;

/// Receptance of a free structure with random modes, and with residual flexibility.
class RandomStructure {
 public:
  RandomStructure(Eigen::Index coordinates, unsigned seed) {
    std::mt19937 generator(seed);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> frequency(20.0, 1500.0);
    shapes_ = Eigen::MatrixXd::NullaryExpr(coordinates, 14, [&] { return normal(generator); });
    for (int mode = 0; mode < 14; ++mode) omega_.push_back(2.0 * std::numbers::pi * (mode < 2 ? 0.0 : frequency(generator)));
  }

  Matrix at(double omega) const {
    Matrix h = 1e-8 * Matrix::Identity(shapes_.rows(), shapes_.rows());
    for (std::size_t mode = 0; mode < omega_.size(); ++mode) {
      const double square = omega_[mode] * omega_[mode];
      const auto shape = shapes_.col(static_cast<Eigen::Index>(mode));
      h += shape * shape.transpose() / std::complex<double>(square - omega * omega, 0.002 * square);
    }
    return h;
  }

 private:
  Eigen::MatrixXd shapes_;
  std::vector<double> omega_;
};

frf::Dof dof(Eigen::Index i) { return {static_cast<std::int64_t>(i), frf::Direction::y, +1}; }

frf::FrfSet empty_set(std::size_t lines, std::size_t first, std::size_t last) {
  frf::FrfSet set;
  for (std::size_t i = 0; i < lines; ++i)
    set.header.frequency_hz.push_back(100.0 + 900.0 * static_cast<double>(i) / static_cast<double>(lines));
  for (std::size_t i = first; i < last; ++i) set.header.response.push_back(dof(static_cast<Eigen::Index>(i)));
  set.header.reference = set.header.response;
  return set;
}

void append(frf::FrfSet& set, const Matrix& h) {
  for (Eigen::Index r = 0; r < h.rows(); ++r) {
    for (Eigen::Index c = 0; c < h.cols(); ++c) set.values.push_back(h(r, c));
  }
}

const std::vector<Eigen::Index> joint = {0, 1, 14, 15};

Eigen::MatrixXd joint_stiffness() {
  Eigen::MatrixXd k(4, 4);
  k << 12, 6, -12, 6, 6, 4, -6, 2, -12, -6, 12, -6, 6, 2, -6, 4;
  return 1e5 * k;
}

}  // namespace

RandomSets random_sets(std::size_t lines) {
  const RandomStructure one(14, 1), two(10, 2);
  frf::FrfSet a = empty_set(lines, 0, 14), b = empty_set(lines, 14, 24), both = empty_set(lines, 0, 24);
  const Eigen::MatrixXd k = joint_stiffness();
  for (std::size_t i = 0; i < lines; ++i) {
    const double omega = 2.0 * std::numbers::pi * a.header.frequency_hz[i];
    Matrix h = Matrix::Zero(24, 24);
    h.topLeftCorner(14, 14) = one.at(omega);
    h.bottomRightCorner(10, 10) = two.at(omega);
    const Matrix z = std::complex<double>(1.0, 0.01) * k.cast<std::complex<double>>();
    const Matrix to_joint = h(joint, Eigen::all), at_joint = h(joint, joint);
    append(a, h.topLeftCorner(14, 14));
    append(b, h.bottomRightCorner(10, 10));
    append(both, h - h(Eigen::all, joint) * dense::solve(Matrix::Identity(4, 4) + z * at_joint, z * to_joint));
  }
  return {std::move(a), std::move(b), std::move(both)};
}

std::vector<frf::Dof> random_joint() {
  std::vector<frf::Dof> dofs;
  for (const Eigen::Index i : joint) dofs.push_back(dof(i));
  return dofs;
}

std::vector<double> true_unknowns() {
  const Eigen::MatrixXd k = joint_stiffness();
  std::vector<double> out;
  for (const double factor : {1.0, 0.01}) {
    for (Eigen::Index r = 0; r < 4; ++r) {
      for (Eigen::Index c = r; c < 4; ++c) out.push_back(factor * k(r, c));
    }
  }
  return out;
}

void pollute(frf::FrfSet& set, double level, std::mt19937& generator) {
  std::normal_distribution<double> normal;
  set.variance.resize(set.values.size());
  set.header.noise = frf::NoiseRecord::variance;
  for (std::size_t line = 0; line < set.header.lines(); ++line) {
    for (std::size_t r = 0; r < set.header.response.size(); ++r) {
      for (std::size_t c = 0; c <= r; ++c) {
        const std::size_t here = set.index(line, r, c), there = set.index(line, c, r);
        const double sigma = level * std::abs(set.values[here]);
        set.values[here] += sigma * Complex(normal(generator), normal(generator));
        set.values[there] = set.values[here];
        set.variance[here] = set.variance[there] = {sigma * sigma, sigma * sigma};
      }
    }
  }
}

}  // namespace jointid::bench
