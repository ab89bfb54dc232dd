#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/complex.hpp"
#include "ident/likelihood/parts/part_groups.hpp"

namespace jointid::ident {

/// FRFs of a group at one line, or what belongs to each of them.
template <class Number>
struct GroupFrfs {
  Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic> motion;             ///< x of the assembly [motions, references]
  std::vector<Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic>> parts;  ///< H of each member [rows, columns]
};

/// A group at one line. `variance` is E|error|², > 0, of the measured values; `current` are corrected ones.
struct GroupLine {
  double omega = 0.0;                 ///< rad/s
  std::size_t line = 0;               ///< of those that are read
  std::vector<std::size_t> columns;   ///< of each unknown of the group: place among the columns of the group
  GroupFrfs<Complex> measured, current;
  GroupFrfs<double> variance;
  Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic> active;  ///< [rows, references]: all of its FRFs are measured

  std::size_t conditions() const { return static_cast<std::size_t>(active.count()); }
};

/// The joint of a group at one line: Z of the rows of its members, and the elements of its derivative by scaled unknowns.
struct GroupImpedance {
  struct Term {
    std::size_t row = 0, column = 0, unknown = 0;
    Complex factor;
  };
  Eigen::MatrixXcd z;  ///< [motions, motions]
  std::vector<Term> terms;
};

GroupImpedance group_impedance(const PartGroup& group, const std::vector<double>& theta, double omega, double omega0);

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
  void form_forces();
  void form_blocks();
  void eliminate();
  Eigen::MatrixXcd derivative(std::size_t reference) const;
  Eigen::MatrixXcd applied(std::size_t reference, const Eigen::MatrixXcd& factors) const;

  const PartGroup& group_;
  const GroupLine& line_;
  const GroupImpedance& z_;
  std::size_t references_;
  Eigen::MatrixXcd motion_of_row_;             ///< G [rows, motions]
  std::vector<Eigen::MatrixXcd> force_;        ///< W of each member: ∂c(m,l)/∂H(m,p) [columns, references]
  std::vector<Eigen::MatrixXd> deviation_;     ///< of H
  std::vector<std::size_t> first_, member_of_row_;
  std::vector<std::pair<std::size_t, Eigen::Index>> force_places_;  ///< of a motion at a joint: its member and column there
  std::vector<Block> blocks_;
  Eigen::MatrixXcd lower_, reduced_, solved_;  ///< P = LLᴴ, Uᴴ D⁻¹ [A w], and P⁻¹ of that
  double cost_ = 0.0;
  Eigen::MatrixXd information_;
  Eigen::VectorXd gradient_;
};

}  // namespace jointid::ident
