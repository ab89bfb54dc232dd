#pragma once

#include <span>

#include "base/eigen.hpp"
#include "ident/likelihood/line/line_data.hpp"
#include "ident/likelihood/line/line_state.hpp"
#include "ident/plan/joint_impedance.hpp"

namespace jointid::ident {

/// One line of the explicit likelihood (output error with free substructure FRFs, docs/formulas.md §11f). What X, Y and Z predict is
///   A = P X,  B = P Y,  D = Xᵀ Z A,  P = (I + Y Z)⁻¹,
/// and a residual is weight · (predicted − measured), one per measured real number, whitened where errors depend on each other. Free
/// are the joint's unknowns and u: X and Y as centre + scale · u, with scale the standard deviation where measured and the size of the
/// FRFs where not. Written without LineModel, whose formulas it checks.
class ExplicitLine {
 public:
  ExplicitLine(const LineLayout& layout, const LineData& data, const JointImpedance& joint);

  std::size_t residuals() const { return rows_.size(); }
  std::size_t own() const { return 2 * layout_->variables(); }

  /// What u is relative to.
  void set_centre(const ComplexMatrix& x, const ComplexMatrix& y);

  /// X, Y, and A and B as they follow from u and the joint.
  LineState state(std::span<const double> theta, const double* u) const;

  ComplexMatrix impedance(std::span<const double> theta) const;

  /// Residuals, and where asked for their derivatives by theta (all columns of the problem) and by u.
  void evaluate(std::span<const double> theta, const double* u, double* residuals, RowMatrixXd* by_theta, RowMatrixXd* by_own) const;

 private:
  /// A measured real number, `at` in the order x, y, a, b, d of stacked().
  struct Row {
    std::size_t at;
    bool imaginary;
    double weight, measured;
  };

  void whiten(Eigen::Ref<RowMatrixXd> rows) const;
  std::vector<Complex> stacked(const ComplexMatrix& x, const ComplexMatrix& y, const ComplexMatrix& a, const ComplexMatrix& b,
                               const ComplexMatrix& d) const;

  const LineLayout* layout_;
  std::vector<Row> rows_;
  std::vector<std::size_t> columns_;
  ComplexMatrix known_;              ///< Z without the unknowns
  std::vector<ComplexMatrix> by_;    ///< ∂Z/∂θ of columns_
  ComplexMatrix x_centre_, y_centre_;
  std::vector<double> scale_;  ///< [own()]
  std::shared_ptr<const minimise::Correlation> correlation_;
};

}  // namespace jointid::ident
