#pragma once

#include <cstdint>
#include <vector>

#include "ident/plan/joint_impedance.hpp"

namespace jointid::ident {

/// FRFs of one line when no joint coordinate of the assembly was measured: M responses and L references that are not of the
/// joint, N joint coordinates.
struct ReachableFrfs {
  Eigen::MatrixXcd aa;  ///< [M × L] of the substructures
  Eigen::MatrixXcd ab;  ///< [M × N]
  Eigen::MatrixXcd ba;  ///< [N × L]
  Eigen::MatrixXcd bb;  ///< [N × N]
  Eigen::MatrixXcd nn;  ///< [M × L] of the assembly
};

/// What one line says of the joint by (6.12), which is nonlinear in it:
///   F(θ) = H_nn − [H_aa − H_ab (I + Z_j H_bb)⁻¹ Z_j H_ba],   ∂F/∂θ = H_nj (∂Z_j/∂θ) H_jn
/// with H_nj = H_ab (I + Z_j H_bb)⁻¹ and H_jn = (I + H_bb Z_j)⁻¹ H_ba (docs/formulas.md §7). Entries that are not fully measured are
/// left out.
class ResponseLine {
 public:
  ResponseLine(ReachableFrfs frfs, JointImpedance joint);

  /// Real equations: real parts of the entries, then imaginary parts. 0 where nothing of the line can be used.
  std::size_t rows() const { return 2 * entries_.size(); }

  const std::vector<std::size_t>& columns() const { return joint_.columns(); }

  /// F for the unknowns of the whole problem, into `f` [rows]. False where I + Z_j H_bb is singular or F not finite.
  bool residual(const std::vector<double>& theta, double* f) const;

  /// The same and ∂F/∂θ of the line's own columns, [rows × columns] row by row.
  bool linearise(const std::vector<double>& theta, double* f, double* jacobian) const;

  /// How alike predicted and measured assembly FRFs are, −1 to 1: Re⟨H_pred, H_nn⟩ over both norms, for residuals `f`. Between a resonance
  /// of the prediction and the matching one of the measurement the prevailing mode has changed its sign in one of them only.
  double correlation(const double* f) const;

  /// ‖H_aa − H_nn‖² over the entries used: F of the free joint.
  double change() const { return change_; }

 private:
  struct Entry {
    Eigen::Index row, column;
  };

  Eigen::MatrixXcd to_joint(const Eigen::MatrixXcd& z) const;
  bool residual_of(const Eigen::MatrixXcd& z, const Eigen::MatrixXcd& h_jn, double* f) const;

  ReachableFrfs frfs_;
  JointImpedance joint_;
  std::vector<Entry> entries_;
  bool reciprocal_ = false;  ///< H_ba is the transpose of H_ab, and H_bb symmetric
  double change_ = 0.0;
};

}  // namespace jointid::ident
