#pragma once

#include "ident/likelihood/parts/group_line.hpp"

namespace jointid::ident {

/// Derivatives of the conditions of a group at its current FRFs and a joint.
class GroupConditions {
 public:
  GroupConditions(const PartGroup& group, std::size_t references, const GroupLine& line, const GroupImpedance& impedance);

  const Eigen::MatrixXcd& by_motion() const { return by_motion_; }  ///< G = ∂c/∂x of any reference [rows, motions]
  const std::vector<Eigen::MatrixXcd>& by_frf() const { return by_frf_; }  ///< W of each member: ∂c(m,l)/∂H(m,p) [columns, references]

  /// A of one reference: ∂c/∂θ [rows, unknowns]
  Eigen::MatrixXcd by_unknown(std::size_t reference) const;

  /// w = c + B (measured − current) [rows, references]
  Eigen::MatrixXcd misfit() const;

 private:
  const PartGroup& group_;
  const GroupLine& line_;
  const GroupImpedance& z_;
  Eigen::MatrixXcd by_motion_;
  std::vector<Eigen::MatrixXcd> by_frf_;
  std::vector<std::pair<std::size_t, Eigen::Index>> force_places_;  ///< of a motion at a joint: its member and column there
};

}  // namespace jointid::ident
