#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "restrictions/impedance_terms.hpp"
#include "restrictions/restriction.hpp"

namespace jointid::restrictions {

/// Z_j at one line as a function of the unknowns of that line, in the scaled form x = {k, ω₀²m, ω₀c, d} (docs/formulas.md §1):
/// Z_j(θ) = Z_known + Σ_t θ_t ∂Z/∂θ_t, N/m.
class JointImpedance {
 public:
  /// Of a line that another process has: no unknowns.
  JointImpedance() = default;

  /// At ω (rad/s); `columns` of the whole problem, and which unknown of the restriction each of them is.
  JointImpedance(const Restriction& restriction, std::vector<std::size_t> columns, const std::vector<std::size_t>& unknown_of,
                 double omega0, double omega);

  /// Which columns of the whole problem the unknowns of this line are; empty where the line lies in no band.
  const std::vector<std::size_t>& columns() const { return columns_; }

  /// Z_j for the columns `theta` of the whole problem.
  Eigen::MatrixXcd at(std::span<const double> theta) const;

  /// Σ_pq left(p) ∂Z(p,q)/∂θ_t right(q) for every unknown t of this line.
  void sensitivity(const Complex* left, const Complex* right, Complex* out) const;

  /// Re Σ_pq conj(∂Z(p,q)/∂θ_t) Q(p,q) for every unknown t of this line.
  Eigen::VectorXd along(const Eigen::MatrixXcd& q) const;

  /// An element of Z that an unknown stands at, and what it is multiplied by there.
  struct Place {
    Eigen::Index row, column;
    Complex factor;
  };
  /// Those of unknown t of this line.
  std::vector<Place> places(std::size_t t) const;

  /// Z without the unknowns.
  const Eigen::MatrixXcd& known() const { return known_; }

  /// Terms by shapes, and the unknowns that have each: numbers of columns().
  std::span<const ImpedanceTerm> terms() const { return terms_; }
  std::span<const ImpedanceShape> shapes() const { return shapes_; }
  std::span<const ImpedancePart> parts() const { return parts_; }

 private:
  std::vector<std::size_t> columns_;
  std::vector<ImpedanceTerm> terms_;
  std::vector<ImpedanceShape> shapes_;
  std::vector<ImpedancePart> parts_;  ///< one per unknown
  Eigen::MatrixXcd known_;
};

}  // namespace jointid::restrictions
