#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "base/complex.hpp"

namespace jointid::response {

/// One error e of a measured FRF: Lᵀ H E is off by e · shape. Errors are independent of each other, real and imaginary part as
/// well.
struct ReceptanceError {
  Eigen::MatrixXd shape;  ///< as Lᵀ H E
  Complex variance;       ///< of real and imaginary part
};

/// Lᵀ H(ω) E of a structure without the forces of its joints: the receptances that joints, responses and forces need, and no
/// others. Rows: the J relative coordinates of the joints, then the responses asked for. Columns: the J joints, then the forces.
class Receptance {
 public:
  virtual ~Receptance() = default;

  virtual Eigen::Index joints() const = 0;
  virtual Eigen::Index responses() const = 0;
  virtual Eigen::Index forces() const = 0;

  /// Whether at(ω) is known, ω ≥ 0 in rad/s.
  virtual bool covers(double omega) const = 0;

  /// Lᵀ H(ω) E, (J + responses) × (J + forces). Throws InputError where it is not known or infinite.
  virtual Eigen::MatrixXcd at(double omega) const = 0;

  /// Lᵀ H′(ω) E, or nothing where the structure is known at single lines only.
  virtual std::optional<Eigen::MatrixXcd> derivative(double omega) const = 0;

  /// ω of the known line nearest to this one, for estimates of what is not covered.
  virtual double nearest(double omega) const { return omega; }

  /// Errors of at(ω); none where nothing is known of them.
  virtual std::vector<ReceptanceError> errors(double) const { return {}; }
};

}  // namespace jointid::response
