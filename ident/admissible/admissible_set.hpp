#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ident/admissible/symmetric_block.hpp"
#include "ident/plan/plan.hpp"

namespace jointid::ident {

/// An inequality that the scene puts on the joint: S(θ) ⪰ 0.
struct Inequality {
  std::string text;      ///< "K positive semidefinite", "K(1,1) >= 0 N/m"
  std::string place;     ///< in the scene
  std::string at_limit;  ///< what is said of its unknowns where it holds with equality
  SymmetricBlock block;  ///< in the scaled unknowns of the columns
};

/// The joints that a scene takes for possible: a convex set of the scaled unknowns θ = offset + directions·w with S_k(θ) ⪰ 0.
struct AdmissibleSet {
  std::vector<Inequality> inequalities;
  Eigen::VectorXd inside;                    ///< some θ with all S_k ≻ 0; empty without inequalities
  std::vector<std::string> ties;             ///< as the scene has them
  std::vector<Eigen::Index> tied;            ///< columns in ties
  Eigen::VectorXd offset;                    ///< of the ties; empty without them
  Eigen::MatrixXd directions;                ///< [columns × free unknowns]; empty without ties
};

/// What the keys definite, bounds and ties of the scene ask for; empty when it has none. The plan has its restriction, columns
/// and ω₀. Throws InputError for unknowns that there are not, matrices that are not symmetric, ties that contradict each
/// other, and conditions that no joint meets with room to spare: then the pattern or other conditions force it onto its edge.
std::shared_ptr<const AdmissibleSet> plan_admissible(const Plan& plan);

}  // namespace jointid::ident
