#pragma once

#include <utility>
#include <vector>

#include "ident/plan/plan.hpp"

namespace jointid::ident {

/// A substructure of a group: the balance of each of its coordinates m under each reference l.
struct GroupMember {
  std::size_t source = 0;             ///< of the substructures
  Dofs rows;                          ///< m
  std::vector<bool> at_joint;         ///< of rows
  std::vector<std::size_t> motions;   ///< of rows: places among the motions of the group
  std::size_t first_row = 0;          ///< among the rows of the group
  Dofs columns;                       ///< forces on it: at its joints, then its references that are at none
  std::vector<std::size_t> forces;    ///< those at joints: places among the motions of the group
  std::vector<std::pair<std::size_t, std::size_t>> references;  ///< reference l on it, column
};

/// Substructures whose conditions are fitted together: they share the motions at the joints between them.
struct PartGroup {
  std::vector<GroupMember> members;
  Dofs motions;                        ///< q of them: of the members and across their joints
  std::size_t rows = 0;                ///< of all members
  std::vector<std::size_t> unknowns;   ///< of the restriction, ascending
  /// Z_j of the rows of its members; rows and columns are places among the motions, unknowns among `unknowns`.
  std::vector<restrictions::MatrixTerms> matrices;

  std::size_t frfs() const;  ///< of the substructures: Σ rows · columns
};

/// What is the same for all groups.
struct PartGroups {
  std::vector<PartGroup> groups;
  Dofs references;               ///< l
  std::vector<bool> at_joint;    ///< of references
  Dofs motions;                  ///< of all groups
  bool wanted[2][2] = {};        ///< [row at joint][reference at joint]: whether the equations take such a balance
};

/// Groups of at most `size` substructures that are joined, in the order of the files; the equations are those of rows by parts.
PartGroups part_groups(const Plan& plan, const std::vector<Equation>& equations, std::size_t size);

/// Flops of one linearisation of all groups at one line.
double linearisation_flops(const PartGroups& groups);

}  // namespace jointid::ident
