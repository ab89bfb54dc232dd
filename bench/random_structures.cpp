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
  RandomStructure(Eigen::Index coordinates, unsigned seed, int modes = 14) {
    std::mt19937 generator(seed);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> frequency(20.0, 1500.0);
    shapes_ = Eigen::MatrixXd::NullaryExpr(coordinates, modes, [&] { return normal(generator); });
    for (int mode = 0; mode < modes; ++mode) omega_.push_back(2.0 * std::numbers::pi * (mode < 2 ? 0.0 : frequency(generator)));
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

/// Both side by side, and with the joint of impedance `z` between the coordinates `joint`.
RandomSets joined(const RandomStructure& one, Eigen::Index first, const RandomStructure& two, Eigen::Index second,
                  const std::vector<Eigen::Index>& joint, const Matrix& z, std::size_t lines) {
  const Eigen::Index size = first + second;
  const auto of = [lines](Eigen::Index from, Eigen::Index to) {
    return empty_set(lines, static_cast<std::size_t>(from), static_cast<std::size_t>(to));
  };
  RandomSets sets{of(0, first), of(first, size), of(0, size)};
  for (std::size_t i = 0; i < lines; ++i) {
    const double omega = angular(sets.a.header.frequency_hz[i]);
    Matrix h = Matrix::Zero(size, size);
    h.topLeftCorner(first, first) = one.at(omega);
    h.bottomRightCorner(second, second) = two.at(omega);
    const Matrix to_joint = h(joint, Eigen::all), at_joint = h(joint, joint), identity = Matrix::Identity(z.rows(), z.rows());
    append(sets.a, h.topLeftCorner(first, first));
    append(sets.b, h.bottomRightCorner(second, second));
    append(sets.both, h - h(Eigen::all, joint) * dense::solve(identity + z * at_joint, z * to_joint));
  }
  return sets;
}

}  // namespace

RandomSets random_sets(std::size_t lines) {
  const Matrix z = std::complex<double>(1.0, 0.01) * joint_stiffness().cast<std::complex<double>>();
  return joined(RandomStructure(14, 1), 14, RandomStructure(10, 2), 10, joint, z, lines);
}

SprungSets sprung_sets(std::size_t lines, std::size_t joint_coordinates, std::size_t others) {
  const auto springs = static_cast<Eigen::Index>(joint_coordinates / 2), half = springs + static_cast<Eigen::Index>(others / 2);
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> factor(0.5, 2.0);
  SprungSets out;
  std::vector<Eigen::Index> places;
  for (Eigen::Index i = 0; i < 2 * springs; ++i) {
    places.push_back(i < springs ? i : half + i - springs);
    out.dofs.push_back(dof(places.back()));
  }
  Matrix z = Matrix::Zero(2 * springs, 2 * springs);
  std::vector<double> damping;
  for (Eigen::Index i = 0; i < springs; ++i) {
    const double k = 1e5 * factor(generator), d = 0.05 * factor(generator) * k;
    const Complex value(k, d);
    z(i, i) = z(springs + i, springs + i) = value;
    z(i, springs + i) = z(springs + i, i) = -value;
    out.springs.push_back({dof(i), dof(half + i)});
    out.truth.push_back(k);
    damping.push_back(d);
  }
  out.truth.insert(out.truth.end(), damping.begin(), damping.end());
  const int modes = static_cast<int>(half);
  out.frfs = joined(RandomStructure(half, 1, modes), half, RandomStructure(half, 2, modes), half, places, z, lines);
  return out;
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
