#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "oscillation/system/contact_system.hpp"

namespace jointid::oscillation {

/// A step's own polynomial: z(t₀ + τ) = Σ c_k τ^k for 0 ≤ τ ≤ length.
struct Piece {
  double start = 0.0, length = 0.0;
  Mode mode = Mode::forward;
  Eigen::MatrixXd coefficients;  ///< [size, order + 1]

  Eigen::VectorXd at(double tau) const;
  /// One linear form of the state, as coefficients of τ.
  Eigen::VectorXd along(const Eigen::VectorXd& form) const { return coefficients.transpose() * form; }
};

/// Taylor series of a contact system in one mode. The linear part goes through the elements of A that are not 0; the falling law
/// G = N e^{−αsV_r} by E' = −αs V_r' E and Cauchy products; variations δG = δN E − αs δV_r G.
class TaylorSeries {
 public:
  static constexpr Eigen::Index order = 24;

  explicit TaylorSeries(const ContactSystem& system);

  /// Coefficients about z, and the length over which the last two terms stay below 1e-17 of the motion and of the drive.
  void expand(Mode mode, const Eigen::VectorXd& z, Piece& piece);
  /// Those of the columns of `tangents` along the piece expanded last: [k] is [size, columns].
  void expand_tangents(const Eigen::MatrixXd& tangents, std::vector<Eigen::MatrixXd>& coefficients);

 private:
  /// What of a matrix is not 0, row by row.
  struct Sparse {
    Sparse() = default;
    explicit Sparse(const Eigen::MatrixXd& a);
    std::vector<std::int32_t> row_start, column;
    std::vector<double> value;
    /// out = A·in times `factor`.
    void multiply(const double* in, double* out, double factor) const;
  };

  static double trusted_length(const Eigen::MatrixXd& coefficients, Eigen::Index motion);
  void limit_fall(double& length) const;

  const ContactSystem& system_;
  std::array<Sparse, 3> drift_;
  std::vector<Eigen::Index> pushed_;  ///< rows where the force acts
  Mode mode_ = Mode::forward;
  bool falls_ = false;
  double rate_ = 0.0, drop_ = 0.0;                                                      ///< αs, s(μ_S − μ_K)
  std::array<Sparse, 3> forms_;                                                         ///< V_r and N by mode
  std::array<double, order + 1> rising_{}, load_{}, decay_{}, reversed_{}, product_{};  ///< j·V_j, N_j, E_j, E_{order−j}, G_j
};

/// The tangents at τ.
Eigen::MatrixXd tangents_at(const std::vector<Eigen::MatrixXd>& coefficients, double tau);

}  // namespace jointid::oscillation
