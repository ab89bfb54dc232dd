#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "base/complex.hpp"

namespace jointid::minimise {

/// What the errors of a line's measured FRFs have in common. With the weights w = 1/σ of real and imaginary part the error e_i of
/// element i is ε_i = Re w_i Re e_i + i Im w_i Im e_i, elements counted through x, y, a, b and d of a LineLayout. They are
/// circular, E[ε ε*] = 2ρ and E[ε εᵀ] = 0, ρ = L Lᴴ in every group; elements of different groups, or of none, are independent. A group
/// whose errors are not has the correlation of its real numbers, first all Re ε, then all Im ε.
class Correlation {
 public:
  struct Group {
    std::vector<std::size_t> elements;
    Eigen::MatrixXcd factor;       ///< L
    Eigen::MatrixXd parts{};       ///< lower factor over real and imaginary parts, [2n, 2n]; empty: they are circular
  };
  struct Place {
    std::size_t group = none, row = 0;
  };
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  /// Groups without an element in common, each of at least two of `elements`.
  Correlation(std::size_t elements, std::vector<Group> groups);

  /// From the covariance of some elements, Hermitian, and their variances: those that depend on each other make a group. Where ρ
  /// is not positive definite the least multiple of I, a power of ten, makes it so.
  static Correlation of(std::size_t elements, const std::vector<std::size_t>& some, const Eigen::MatrixXcd& covariance,
                        const Eigen::VectorXd& variance);

  /// The same with E[e eᵀ] and the variances of real and imaginary parts: a group with some of that is not circular, others are taken
  /// so. An empty relation is zero.
  static Correlation of(std::size_t elements, const std::vector<std::size_t>& some, const Eigen::MatrixXcd& covariance,
                        const Eigen::MatrixXcd& relation, const Eigen::VectorXcd& variance);

  const std::vector<Group>& groups() const { return groups_; }
  bool is_circular() const;
  Place place(std::size_t element) const { return places_[element]; }

  /// L⁻¹ and L times the errors of each group, [elements]: independent ones from those that are not, and back.
  void whiten(std::span<Complex> errors) const;
  void colour(std::span<Complex> errors) const;

  std::size_t bytes() const;

 private:
  std::vector<Group> groups_;
  std::vector<Place> places_;
};

}  // namespace jointid::minimise
