#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>
#include <vector>

namespace jointid::ident {

/// A chain of Euler–Bernoulli beams, two elements each, joint e between the last node of beam e and the first of e + 1: the
/// structure `chain50` of the golden values, of any length. Coordinates of a beam: y, θ node by node.
struct BeamChain {
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  using Complex6 = Eigen::Matrix<std::complex<double>, 6, 6>;
  using Complex2 = Eigen::Matrix<std::complex<double>, 2, 2>;

  std::size_t joints = 50;
  double length = 0.4, spread = 0.05, phase = 0.3, width = 0.03, height = 0.01, e = 2.1e11, rho = 7800.0, eta = 0.004;
  double k = 2e5, kr = 60.0, c = 300.0, loss = 0.04;
  std::vector<double> lost{};  ///< of the stiffness of each joint; empty: nothing

  std::size_t parts() const { return joints + 1; }

  /// Stiffness and mass of a beam.
  std::pair<Matrix6, Matrix6> beam(std::size_t part) const {
    const double l = length * (1.0 + spread * std::sin(1.7 * double(part) + phase)) / 2.0;
    const double ei = e * width * std::pow(height, 3) / 12.0, m = rho * width * height * l / 420.0, s = ei / (l * l * l);
    Eigen::Matrix4d stiff, mass;
    stiff << 12, 6 * l, -12, 6 * l, 6 * l, 4 * l * l, -6 * l, 2 * l * l, -12, -6 * l, 12, -6 * l, 6 * l, 2 * l * l, -6 * l,
        4 * l * l;
    mass << 156, 22 * l, 54, -13 * l, 22 * l, 4 * l * l, 13 * l, -3 * l * l, 54, 13 * l, 156, -22 * l, -13 * l, -3 * l * l,
        -22 * l, 4 * l * l;
    std::pair<Matrix6, Matrix6> out{Matrix6::Zero(), Matrix6::Zero()};
    for (int element = 0; element < 2; ++element) {
      out.first.block<4, 4>(2 * element, 2 * element) += s * stiff;
      out.second.block<4, 4>(2 * element, 2 * element) += m * mass;
    }
    return out;
  }

  /// K₁₁, K₁₂, K₂₂, D₁₁, D₁₂, D₂₂ of a joint.
  std::array<double, 6> joint(std::size_t number) const {
    const auto v = [&](double q) { return 1.0 + 0.3 * std::sin(1.7 * (double(number) + q) + 0.3); };
    const double k11 = k * v(0), k12 = c * v(3), k22 = kr * v(7), left = lost.empty() ? 1.0 : 1.0 - lost[number];
    return {left * k11, left * k12, left * k22, loss * k11, 0.5 * loss * k12, 1.3 * loss * k22};
  }

  Complex2 impedance(std::size_t number) const {
    const auto [k11, k12, k22, d11, d12, d22] = joint(number);
    Complex2 out;
    out << std::complex(k11, d11), std::complex(k12, d12), std::complex(k12, d12), std::complex(k22, d22);
    return out;
  }

  Complex6 dynamic_stiffness(std::size_t part, double omega) const {
    const auto [stiff, mass] = beam(part);
    return std::complex(1.0, eta) * stiff.cast<std::complex<double>>() - omega * omega * mass.cast<std::complex<double>>();
  }

  /// Of a beam on its own.
  Complex6 free_frfs(std::size_t part, double omega) const { return dynamic_stiffness(part, omega).inverse(); }

  /// FRFs of the chain: [6·parts × columns] for a unit force at a coordinate of a part each.
  Eigen::MatrixXcd chain_frfs(double omega, const std::vector<std::pair<std::size_t, std::size_t>>& forces) const {
    const auto columns = Eigen::Index(forces.size());
    std::vector<Complex6> diagonal;
    std::vector<Eigen::Matrix<std::complex<double>, 6, Eigen::Dynamic>> right(parts());
    for (std::size_t s = 0; s < parts(); ++s) {
      diagonal.push_back(dynamic_stiffness(s, omega));
      if (s > 0) diagonal.back().block<2, 2>(0, 0) += impedance(s - 1);
      if (s < joints) diagonal.back().block<2, 2>(4, 4) += impedance(s);
      right[s].setZero(6, columns);
    }
    for (std::size_t i = 0; i < forces.size(); ++i) right[forces[i].first](Eigen::Index(forces[i].second), Eigen::Index(i)) = 1.0;
    for (std::size_t s = 0; s < joints; ++s) {  // block elimination
      Complex6 down = Complex6::Zero();
      down.block<2, 2>(0, 4) = -impedance(s);
      const Complex6 factor = down * diagonal[s].inverse();
      diagonal[s + 1] -= factor * down.transpose();
      right[s + 1] -= (factor * right[s]).eval();
    }
    Eigen::MatrixXcd out(6 * Eigen::Index(parts()), columns);
    for (std::size_t s = parts(); s-- > 0;) {
      Eigen::MatrixXcd rest = right[s];
      if (s < joints) rest.bottomRows(2) += impedance(s) * out.middleRows(6 * Eigen::Index(s + 1), 2);
      out.middleRows(6 * Eigen::Index(s), 6) = diagonal[s].inverse() * rest;
    }
    return out;
  }

  /// RᵀR of the local rows (2) over y = θ/truth, each line divided by the largest modulus of its coefficients.
  Eigen::MatrixXd local_information(const std::vector<double>& lines_hz,
                                    const std::vector<std::pair<std::size_t, std::size_t>>& references) const {
    const auto n = 6 * Eigen::Index(joints);
    Eigen::MatrixXd information = Eigen::MatrixXd::Zero(n, n);
    for (const double hz : lines_hz) {
      const double omega = 2.0 * std::numbers::pi * hz;
      const Eigen::MatrixXcd x = chain_frfs(omega, references);
      Eigen::MatrixXd line = Eigen::MatrixXd::Zero(n, n);
      double largest = 0.0;
      for (std::size_t s = 0; s < parts(); ++s) {
        const Complex6 h = free_frfs(s, omega);
        for (Eigen::Index l = 0; l < x.cols(); ++l) {
          Eigen::Matrix<std::complex<double>, 6, 12> rows = Eigen::Matrix<std::complex<double>, 6, 12>::Zero();
          if (s > 0)
            add_joint(h.leftCols<2>(), x.block<2, 1>(6 * Eigen::Index(s), l) - x.block<2, 1>(6 * Eigen::Index(s) - 2, l), s - 1,
                      0, rows);
          if (s < joints)
            add_joint(h.rightCols<2>(), x.block<2, 1>(6 * Eigen::Index(s) + 4, l) - x.block<2, 1>(6 * Eigen::Index(s) + 6, l), s,
                      6, rows);
          largest = std::max(largest, rows.cwiseAbs().maxCoeff());
          const Eigen::Matrix<double, 12, 12> square = (rows.adjoint() * rows).real();
          for (Eigen::Index u = 0; u < 12; ++u) {
            for (Eigen::Index v = 0; v < 12; ++v) {
              const Eigen::Index row = 6 * Eigen::Index(s) - 6 + u, column = 6 * Eigen::Index(s) - 6 + v;
              if (row >= 0 && column >= 0 && row < n && column < n) line(row, column) += square(u, v);
            }
          }
        }
      }
      information += line / (largest * largest);
    }
    return information;
  }

 private:
  void add_joint(const Eigen::Matrix<std::complex<double>, 6, 2>& h, const Eigen::Matrix<std::complex<double>, 2, 1>& relative,
                 std::size_t number, Eigen::Index first, Eigen::Matrix<std::complex<double>, 6, 12>& rows) const {
    const std::array<double, 6> truth = joint(number);
    for (Eigen::Index kind = 0; kind < 2; ++kind) {
      const std::complex<double> factor = kind == 0 ? 1.0 : std::complex(0.0, 1.0);
      rows.col(first + 3 * kind) += factor * truth[std::size_t(3 * kind)] * relative[0] * h.col(0);
      rows.col(first + 3 * kind + 1) +=
          factor * truth[std::size_t(3 * kind + 1)] * (relative[1] * h.col(0) + relative[0] * h.col(1));
      rows.col(first + 3 * kind + 2) += factor * truth[std::size_t(3 * kind + 2)] * relative[1] * h.col(1);
    }
  }
};

}  // namespace jointid::ident
