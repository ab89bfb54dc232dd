#pragma once

#include "response/structure/matrix_structure.hpp"
#include "response/structure/receptance.hpp"

namespace jointid::response {

/// Receptances from M, C, K: H = (K + iωC − ω²M)⁻¹, dH/dω = −H(−2ωM + iC)H.
class MatrixReceptance final : public Receptance {
 public:
  /// `joints` (N × J): W, a column for each relative coordinate q = Wᵀx; `responses` (N × R): x is seen as responsesᵀx; `forces`
  /// (N × P): where forces act. Throws InputError when sizes disagree or a number is not finite.
  MatrixReceptance(MatrixStructure structure, Eigen::MatrixXd joints, const Eigen::MatrixXd& responses,
                   const Eigen::MatrixXd& forces);

  Eigen::Index joints() const override { return joints_; }
  Eigen::Index responses() const override { return left_.cols() - joints_; }
  Eigen::Index forces() const override { return right_.cols() - joints_; }
  bool covers(double) const override { return true; }
  Eigen::MatrixXcd at(double omega) const override;
  std::optional<Eigen::MatrixXcd> derivative(double omega) const override;

  const MatrixStructure& structure() const { return structure_; }

 private:
  Eigen::MatrixXcd dynamic_stiffness(double omega) const;

  MatrixStructure structure_;
  Eigen::Index joints_;
  Eigen::MatrixXd left_, right_;  ///< [W, responses], [W, forces]
};

}  // namespace jointid::response
