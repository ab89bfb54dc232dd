#pragma once

#include "ident/likelihood/parts/group_conditions.hpp"

namespace jointid::ident {

/// The conditions of a group at one line, for m on member s and reference l,
///   c(m,l) = x(m,l) − [l on s] H(m,l) + Σ_p H(m,p) F(p,l) = 0,  F = Z x,
/// linearised at its current FRFs: c + B e + A δθ = 0 with errors e of the variances Q. With M = B Q Bᴴ and
/// w = c + B (measured − current) the cost is wᴴM⁻¹w; information Re AᴴM⁻¹A and gradient Re AᴴM⁻¹w. M is a block for each
/// reference, from errors of x, and of low rank beside, from those of H.
class GroupLinearisation {
 public:
  GroupLinearisation(const PartGroup& group, const PartGroups& all, const GroupLine& line, const GroupImpedance& impedance);

  double cost() const { return cost_; }
  const Eigen::MatrixXd& information() const { return information_; }  ///< of the unknowns of the group
  const Eigen::VectorXd& gradient() const { return gradient_; }

  /// The FRFs nearest to the measured ones that meet the linearised conditions after a step of the unknowns.
  GroupFrfs<Complex> corrected(const Eigen::VectorXd& step) const;

  /// Gᴴ(M⁻¹A) of reference l, G = ∂c/∂x: an error e of x(:,l) changes the gradient by Re(this)ᴴe. [motions, unknowns]
  Eigen::MatrixXcd answer(std::size_t reference) const;

 private:
  /// Of one reference: the inverse of its block of M, with zeros for conditions that are not there; A and w; the one times the other.
  struct Block {
    Eigen::MatrixXcd inverse, plain, right;
  };
  void form_blocks();
  void eliminate();
  Eigen::MatrixXcd applied(std::size_t reference, const Eigen::MatrixXcd& factors) const;

  const PartGroup& group_;
  const GroupLine& line_;
  std::size_t references_;
  GroupConditions conditions_;
  std::vector<Eigen::MatrixXd> deviation_;     ///< of H
  std::vector<std::size_t> first_, member_of_row_;
  std::vector<Block> blocks_;
  Eigen::MatrixXcd lower_, reduced_, solved_;  ///< P = LLᴴ, Uᴴ D⁻¹ [A w], and P⁻¹ of that
  double cost_ = 0.0;
  Eigen::MatrixXd information_;
  Eigen::VectorXd gradient_;
};

}  // namespace jointid::ident
