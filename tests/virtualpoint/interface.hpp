#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "base/eigen.hpp"
#include "frf/set/frf_set.hpp"
#include "virtualpoint/virtual_point.hpp"

namespace jointid::virtualpoint {

/// A rigid interface by numbers drawn at random: triaxial sensors at four corners, impacts of all directions, and FRFs of its
/// motion.
struct Interface {
  static constexpr std::size_t lines = 5;

  explicit Interface(unsigned seed, std::size_t corners = 4, std::size_t blows = 9) : random(seed) {
    point.position = {0.3, -0.2, 0.1};
    point.modes = rigid_modes();
    std::int64_t node = 1;
    for (std::size_t i = 0; i < corners; ++i, ++node) {
      place(node);
      for (const auto direction : {frf::Direction::x, frf::Direction::y, frf::Direction::z}) {
        const int sign = number() > 0.0 ? 1 : -1;
        point.sensors.push_back({.dof = {.node = node, .direction = direction, .sign = sign}});
        set.header.response.push_back({.node = node, .direction = direction});
      }
    }
    for (std::size_t i = 0; i < blows; ++i, ++node) {
      place(node);
      const Eigen::Vector3d d = Eigen::Vector3d(number(), number(), number()).normalized();
      const frf::Dof dof{.node = node, .direction = frf::Direction::z};
      point.impacts.push_back({.dof = dof, .direction = Vector{d[0], d[1], d[2]}});
      set.header.reference.push_back(dof);
    }
    set.header.file = "interface";
    for (std::size_t line = 0; line < lines; ++line) {
      set.header.frequency_hz.push_back(10.0 * static_cast<double>(line + 1));
      motion.push_back(random_matrix(6, 6));
    }
    write_frfs();
  }

  double number() { return std::uniform_real_distribution<double>(-1.0, 1.0)(random); }

  Eigen::MatrixXcd random_matrix(Eigen::Index rows, Eigen::Index columns) {
    Eigen::MatrixXcd out(rows, columns);
    for (Complex& value : out.reshaped()) value = {number(), number()};
    return out;
  }

  /// Round the point, about 0.1 m from it.
  void place(std::int64_t node) {
    const double turn = 2.4 * static_cast<double>(node);
    const Vector from = {0.1 * std::cos(turn), 0.1 * std::sin(turn), node % 2 == 0 ? 0.05 : -0.05};
    frf::Node there{.id = node, .position = point.position};
    for (std::size_t k = 0; k < 3; ++k) there.position[k] += from[k] + 0.02 * number();
    set.header.nodes.push_back(there);
  }

  Eigen::Vector3d lever(const frf::Dof& dof) const {
    const frf::Node& node = set.header.nodes[static_cast<std::size_t>(dof.node - 1)];
    return Eigen::Vector3d(node.position.data()) - Eigen::Vector3d(point.position.data());
  }

  /// What a rigid body's motion (x, θ) is at the channel: d·(x + θ × r), written without the library.
  Eigen::RowVectorXd row(const frf::Dof& dof, const Eigen::Vector3d& d) const {
    Eigen::RowVectorXd out(6);
    out << d.transpose(), lever(dof).cross(d).transpose();
    return out;
  }

  Eigen::MatrixXd sensor_rows() const {
    Eigen::MatrixXd out(at(set.header.response.size()), 6);
    for (Eigen::Index i = 0; i < out.rows(); ++i) {
      const frf::Dof& dof = set.header.response[static_cast<std::size_t>(i)];
      out.row(i) = row(dof, Eigen::Vector3d::Unit(static_cast<int>(dof.direction) - 1));
    }
    return out;
  }

  Eigen::MatrixXd impact_rows() const {
    Eigen::MatrixXd out(at(point.impacts.size()), 6);
    for (Eigen::Index i = 0; i < out.rows(); ++i) {
      const Channel& impact = point.impacts[static_cast<std::size_t>(i)];
      out.row(i) = row(impact.dof, Eigen::Vector3d(impact.direction->data()));
    }
    return out;
  }

  /// FRFs of all channels from those of the motion.
  void write_frfs() {
    const Eigen::MatrixXcd left = sensor_rows().cast<Complex>(), right = impact_rows().transpose().cast<Complex>();
    set.values.clear();
    for (const Eigen::MatrixXcd& h : motion) {
      const RowMatrixXc y = left * h * right;
      set.values.insert(set.values.end(), y.data(), y.data() + y.size());
    }
  }

  Eigen::Map<const RowMatrixXc> line(std::size_t i) const {
    const Eigen::Index rows = at(set.header.response.size()), columns = at(set.header.reference.size());
    return {set.values.data() + static_cast<std::ptrdiff_t>(i) * rows * columns, rows, columns};
  }

  std::mt19937_64 random;
  VirtualPoint point;
  frf::FrfSet set;
  std::vector<Eigen::MatrixXcd> motion;  ///< [6,6] a line, loads to motion at the point
};

}  // namespace jointid::virtualpoint
