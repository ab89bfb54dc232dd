#pragma once

#include <string>
#include <vector>

#include "restrictions/joint_spec.hpp"
#include "restrictions/matrix_terms.hpp"

namespace jointid::restrictions {

/// An unknown of one matrix of one joint, e.g. "K(1,2)", before the joint's prefix.
struct LocalUnknown {
  std::string name;
  std::string unit;
};

/// One matrix of one joint in the joint's own numbering; the indices of the terms run over `unknowns`.
/// Elements may come in any order and repeatedly: build() sums and sorts them.
struct LocalMatrix {
  std::vector<LocalUnknown> unknowns;
  std::vector<Term> terms;
  std::vector<Known> known;
};

/// Patterns full, symmetric (upper triangle) and diagonal: unknowns "K(row,column)" from 1, row by row.
LocalMatrix from_pattern(const JointSpec& joint, Kind kind, Pattern pattern);

/// A matrix of numbers and linear expressions: unknowns "K.name" in order of first appearance, row by row.
LocalMatrix from_entries(const JointSpec& joint, Kind kind, const EntryMatrix& entries);

/// Springs X = Σ y_s b_s b_sᵀ in the order listed, b_s = e_first − e_second (second missing for ground) with the signs
/// of the DOFs. Unknowns "K[4:+Y,5:+Y]", "K[4:+RZ,ground]".
LocalMatrix from_springs(const JointSpec& joint, Kind kind, const std::vector<Spring>& springs);

/// Pattern free: X = V N S Nᵀ V with S symmetric, unknowns "K.s(i,j)", i ≤ j. See rigid_body.hpp for V and N.
LocalMatrix from_free_pattern(const JointSpec& joint, Kind kind);

/// An InputError (usage) at "[joint.stiffness]", or at "joint 'left', stiffness" for a joint with a name.
[[noreturn]] void fail(const JointSpec& joint, Kind kind, const std::string& problem, const std::string& remedy);

}  // namespace jointid::restrictions
