#pragma once

#include <Eigen/SparseCore>

#include "response/structure/receptance.hpp"

namespace jointid::response {

/// As MatrixStructure, of large models: only what is not zero.
struct SparseStructure {
  Eigen::SparseMatrix<double> mass, damping, stiffness;
};

/// Receptances from sparse symmetric M, C, K: at every ω one sparse factorisation of K + iωC − ω²M and a solution for each joint
/// and force. Nothing else of the model is computed.
class SparseReceptance final : public Receptance {
 public:
  /// As MatrixReceptance. Throws InputError when sizes disagree or a number is not finite.
  SparseReceptance(SparseStructure structure, const Eigen::MatrixXd& joints, const Eigen::MatrixXd& responses,
                   const Eigen::MatrixXd& forces);

  Eigen::Index joints() const override { return joints_; }
  Eigen::Index responses() const override { return left_.cols() - joints_; }
  Eigen::Index forces() const override { return right_.cols() - joints_; }
  bool covers(double) const override { return true; }
  Eigen::MatrixXcd at(double omega) const override;
  std::optional<Eigen::MatrixXcd> derivative(double omega) const override;

 private:
  SparseStructure structure_;
  Eigen::Index joints_;
  Eigen::MatrixXcd left_, right_;  ///< [W, responses], [W, forces]
};

}  // namespace jointid::response
